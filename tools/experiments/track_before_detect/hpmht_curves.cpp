#include "tools/experiments/track_before_detect/hpmht_curves.hpp"

#include <array>
#include <string>

#include "tools/experiments/track_before_detect/sonar_score.hpp"

namespace lookout::tools {
namespace {

/// How a method confirms a track: what is swept.
struct Rule {
  const char* method;
  const char* name;
  int hits, window;  // of a baseline: M of N
  std::array<double, 5> thresholds;
};

// Of h_pmht the existence that confirms; of the baselines the peak's threshold.
constexpr std::array<Rule, 4> kRules{{{"h_pmht", "existence", 0, 0, {0.8, 0.95, 0.98, 0.995, 0.999}},
                                      {"mf_nn", "3 of 4", 3, 4, {2.2, 2.3, 2.45, 2.6, 2.75}},
                                      {"mf_nn", "4 of 6", 4, 6, {1.9, 2.0, 2.1, 2.2, 2.4}},
                                      {"cfar_nn", "4 of 6", 4, 6, {2.3, 2.45, 2.6, 2.75, 2.9}}}};

const Rule& rule_of(const Cell& cell) {
  for (const Rule& rule : kRules)
    if (cell.method == rule.method && cell.parameters.text("rule") == rule.name) return rule;
  return kRules.front();
}

std::unique_ptr<tracking::CellTargetTracker> targets_of(const Cell& cell) {
  const double threshold = cell.parameters.number("threshold");
  if (cell.method == "h_pmht") {
    tracking::CellTrackerParams params = tracking::sonar_tracker_params(sonar_instrument(true));
    params.existence.confirm_existence = threshold;
    return std::make_unique<tracking::CellTracker>(params);
  }
  const Rule& rule = rule_of(cell);
  tracking::PeakTrackerParams params =
      cell.method == "mf_nn" ? tracking::matched_filter_baseline() : tracking::cfar_baseline();
  params.threshold = threshold;
  params.confirm_hits = rule.hits;
  params.confirm_window = rule.window;
  return std::make_unique<tracking::PeakTracker>(params);
}

class HpmhtCurves : public Experiment {
 public:
  std::string summary() const override {
    return "Time in track against false tracks in sonar images, by each method's threshold, 6 and 8 dB";
  }
  std::string scenario() const override { return "tools/scenarios/sonar_image.yaml"; }
  std::string plot_script() const override { return "plot_hpmht.py"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const double snr_db : {6.0, 8.0})
      for (const Rule& rule : kRules)
        for (const double threshold : rule.thresholds)
          cells.push_back(
              {rule.method, {{"snr_db", snr_db}, {"rule", rule.name}, {"threshold", threshold}}, {}});
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    tracking::ImageTracker tracker(targets_of(cell), {});
    return score_run(tracker, sonar_scene(cell.parameters), seed, run).metrics();
  }

  Pooling pooling(const std::string& metric) const override {
    return metric == "rmse" ? Pooling::root_mean_square : Pooling::mean;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_hpmht_curves() {
  return std::make_unique<HpmhtCurves>();
}

}  // namespace lookout::tools
