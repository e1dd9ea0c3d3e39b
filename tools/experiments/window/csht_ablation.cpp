#include "tools/experiments/window/csht_ablation.hpp"

#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/paper_figures.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/window/csht_ladder.hpp"
#include "tools/experiments/window/window_run.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "window_table2.yaml";
constexpr double kProbabilities[] = {0.1, 0.3, 0.5, 0.7};
constexpr double kPaperProbability = 0.3;  ///< Of the other sigmas.
constexpr double kPaperSigma = 3.0;        ///< Of the 16 pairs of probabilities [m].
constexpr double kOtherSigmas[] = {1.0, 2.0, 4.0, 5.0};
constexpr int kCostlyRuns = 20;  ///< Literal clutter: a window takes a tenth of a second.

Cell cell_of(const std::string& rung, const std::string& clutter, double p_false_alarm, double p_miss,
             double sigma, const PaperFigures& paper) {
  Cell cell;
  cell.method = rung.starts_with("A") ? "csht_printed" : "csht";
  cell.parameters = {{"p_false_alarm", p_false_alarm},
                     {"p_miss", p_miss},
                     {"sigma", sigma},
                     {"clutter", clutter},
                     {"variant", rung}};
  cell.paper = paper.at("csht", cell.parameters);
  if (clutter == "literal") cell.max_runs = kCostlyRuns;
  return cell;
}

class CshtAblation : public Experiment {
 public:
  std::string summary() const override {
    return "What each step from [Yan2018] as printed to csht brings, on the windows of Tables 3 to 6";
  }
  std::string scenario() const override { return std::string("tools/scenarios/") + kScene; }
  std::string plot_script() const override { return "plot_ablation.py"; }

  std::vector<Cell> cells() const override {
    const PaperFigures paper("yan2018_window_tables.csv");
    std::vector<Cell> cells;
    for (const std::string clutter : {"light", "literal"}) {
      for (const auto& rung : ladder_rungs()) {
        for (const double p_miss : kProbabilities)
          for (const double p_false_alarm : kProbabilities)
            cells.push_back(cell_of(rung, clutter, p_false_alarm, p_miss, kPaperSigma, paper));
        for (const double sigma : kOtherSigmas)
          cells.push_back(cell_of(rung, clutter, kPaperProbability, kPaperProbability, sigma, paper));
      }
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto& p = cell.parameters;
    const auto scene = load_variant(kScene, {p.number("p_false_alarm"), p.number("p_miss"), p.number("sigma"),
                                             clutter_reading(p.text("clutter"))});
    const auto scans = simulate(scene, seed, run);
    const auto sonar = sonar_sim::known_params(scene, scene.platforms.front());
    const LadderEstimator rung = make_rung(p.text("variant"), static_cast<int>(scans.size()), sonar);
    const WindowAnswer answer = estimate_window(*rung.estimator, scans);
    Metrics metrics = score_window(scans, sonar, answer);
    metrics["found"] = static_cast<double>(answer.elements.size());
    if (rung.classes) metrics["classes"] = rung.classes();
    return metrics;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_csht_ablation() {
  return std::make_unique<CshtAblation>();
}

}  // namespace lookout::tools
