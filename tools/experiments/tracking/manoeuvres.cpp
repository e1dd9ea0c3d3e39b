#include "tools/experiments/tracking/manoeuvres.hpp"

#include <array>
#include <cmath>
#include <span>
#include <string>

#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

/// A scene and what it is to be held against.
struct Situation {
  const char* name;  ///< Also of its file.
  const char* twin;  ///< The same targets without the manoeuvre; null: none.
};

constexpr std::array kManoeuvring{Situation{"turn_6deg", "turn_6deg_straight"},
                                  Situation{"acceleration", "acceleration_straight"},
                                  Situation{"manoeuvring", nullptr}, Situation{"turning_vehicle", nullptr}};
constexpr std::array kMeeting{Situation{"crossing_45deg", nullptr}, Situation{"crossing", nullptr},
                              Situation{"overtaking", nullptr}, Situation{"parallel_8m", nullptr}};
constexpr std::array kPoses{Situation{"pose_noise", "tracking_table7"},
                            Situation{"pose_faults", "tracking_table7"}};
constexpr std::array kMethods{"joint", "kalman", "gnn"};

/// P_F and P_M.
struct Figures {
  double false_alarm;
  double miss;
};
constexpr std::array kManoeuvringFigures{Figures{0.1, 0.1}, Figures{0.3, 0.3}};
constexpr std::array kMeetingFigures{Figures{0.1, 0.3}};
constexpr std::array kPoseFigures{Figures{0.3, 0.3}};

template <class Situations, class AllFigures>
void add_cells(const Situations& situations, const AllFigures& all_figures, std::vector<Cell>& cells) {
  for (const Situation& situation : situations) {
    for (const Figures& figures : all_figures) {
      for (const char* method : kMethods) {
        Cell cell;
        cell.method = method;
        cell.parameters = {{"situation", std::string(situation.name)},
                           {"p_false_alarm", figures.false_alarm},
                           {"p_miss", figures.miss},
                           {"sigma", 3.0},
                           {"clutter", std::string("literal")}};
        cells.push_back(cell);
      }
    }
  }
}

const char* twin_of(const std::string& name) {
  for (const auto& situations :
       {std::span<const Situation>(kManoeuvring), std::span<const Situation>(kPoses)})
    for (const Situation& situation : situations)
      if (name == situation.name) return situation.twin;
  return nullptr;
}

/// The figures of one method on one scene, its scans posed by the intake of the live chain.
Metrics track_scene(const std::string& name, const Cell& cell, std::uint64_t seed, int run) {
  const SceneVariant variant{cell.parameters.number("p_false_alarm"), cell.parameters.number("p_miss"),
                             cell.parameters.number("sigma"), sonar_sim::ClutterReading::literal};
  const sonar_sim::Scene scene = load_variant(name + ".yaml", variant);
  const auto scans = simulate_through_intake(scene, seed, run);
  const core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms[0]);
  const auto pipeline = pipeline_of(cell.method, sonar, run_seed(seed, run));
  Metrics metrics = score(scans, track(*pipeline, scans));
  const double period = scene.platforms[0].sonar.params.scan_period;
  metrics["posed_share"] = static_cast<double>(scans.size()) / std::round(scene.duration / period);
  return metrics;
}

class Manoeuvres : public Experiment {
 public:
  std::string summary() const override {
    return "Targets that turn, change speed or meet, a vehicle that turns, poses that are noisy, late or "
           "lost";
  }
  std::string scenario() const override { return "tools/scenarios/SITUATION.yaml"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    add_cells(kManoeuvring, kManoeuvringFigures, cells);
    add_cells(kMeeting, kMeetingFigures, cells);
    add_cells(kPoses, kPoseFigures, cells);
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const std::string name = cell.parameters.text("situation");
    Metrics metrics = track_scene(name, cell, seed, run);
    if (const char* twin = twin_of(name))
      metrics["ospa_twin"] = track_scene(twin, cell, seed, run).at("ospa");
    return metrics;
  }

  /// How much the manoeuvre costs: a ratio of means, for single runs divide by small numbers.
  void complete(Estimates& estimates) const override {
    const auto twin = estimates.find("ospa_twin");
    if (twin == estimates.end() || twin->second.mean <= 0.0) return;
    const Estimate& own = estimates.at("ospa");
    const double ratio = own.mean / twin->second.mean;
    const double relative = std::hypot(own.ci95 / own.mean, twin->second.ci95 / twin->second.mean);
    estimates["ospa_over_twin"] = {ratio, ratio * relative, own.runs};
  }
};

}  // namespace

std::unique_ptr<Experiment> make_manoeuvres() {
  return std::make_unique<Manoeuvres>();
}

}  // namespace lookout::tools
