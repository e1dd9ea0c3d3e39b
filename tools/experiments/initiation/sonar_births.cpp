#include "tools/experiments/initiation/sonar_births.hpp"

#include <array>

#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "tracking_table7.yaml";
/// The plainest tracker: it follows what was begun, right or wrong.
constexpr const char* kTracker = "gnn";
/// P_F and P_M alike.
constexpr std::array kProbabilities{0.1, 0.3};

class SonarBirths : public Experiment {
 public:
  std::string summary() const override {
    return "The sonar's scene with tracks begun by every initiator, followed by one tracker";
  }
  std::string scenario() const override { return std::string("tools/scenarios/") + kScene; }

  std::vector<Cell> cells() const override {
    std::vector<std::string> methods{kTracker};
    for (const auto& name : tracking::initiator_names()) methods.push_back(name);
    std::vector<Cell> cells;
    for (const char* clutter : {"light", "literal"}) {
      for (const double probability : kProbabilities) {
        for (const auto& method : methods)
          cells.push_back({method,
                           {{"p_false_alarm", probability},
                            {"p_miss", probability},
                            {"sigma", 3.0},
                            {"clutter", std::string(clutter)}},
                           {}});
      }
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const SceneVariant variant{cell.parameters.number("p_false_alarm"), cell.parameters.number("p_miss"),
                               cell.parameters.number("sigma"),
                               clutter_reading(cell.parameters.text("clutter"))};
    const sonar_sim::Scene scene = load_variant(kScene, variant);
    const auto scans = simulate(scene, seed, run);
    tracking::ChainParams params;
    params.tracker.name = kTracker;
    params.tracker.initiator = cell.method;
    params.seed = run_seed(seed, run);
    const core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms[0]);
    const auto pipeline = tracking::make_pipeline(params, sonar);
    return score(scans, track(*pipeline, scans));
  }
};

}  // namespace

std::unique_ptr<Experiment> make_sonar_births() {
  return std::make_unique<SonarBirths>();
}

}  // namespace lookout::tools
