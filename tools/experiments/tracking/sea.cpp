#include "tools/experiments/tracking/sea.hpp"

#include <algorithm>
#include <string>

#include "core/frames.hpp"
#include "tools/experiments/harness/quantiles.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/tracking/clutter_picture.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tools/experiments/tracking/sea_scene.hpp"
#include "tools/experiments/tracking/sensor_knowledge.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

constexpr double kProbabilities[] = {0.1, 0.3};  // of P_F and P_M alike
constexpr const char* kFigures[] = {"unknown", "known", "half", "double"};
constexpr double kSettled = 10.0;  // s: scores are from then on
constexpr double kLater = 25.0;    // s: and once more from then on, as *_later
constexpr int kJointRuns = 30;
constexpr int kRivalRuns = 5;
constexpr double kHighQuantile = 0.99;  // Of the processor times of a run's scans.

Cell make_cell(const SeaSetting& setting, const std::string& method, const char* figures) {
  Cell cell;
  cell.method = method;
  cell.parameters = {{"condition", setting.condition},
                     {"targets", setting.targets},
                     {"p_false_alarm", setting.p_false_alarm},
                     {"p_miss", setting.p_miss},
                     {"sensor_figures", std::string(figures)}};
  cell.max_runs = method == "joint" ? kJointRuns : kRivalRuns;
  return cell;
}

/// What the tracker is told. Unknown: neither probability, so that it learns them or goes by its defaults.
core::SonarParams told(const Cell& cell, const sonar_sim::Scene& scene, std::uint64_t seed, int run) {
  const std::string figures = cell.parameters.text("sensor_figures");
  if (figures != "unknown") return told_params(scene, {}, figures, seed, run);
  core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms.front());
  sonar.miss_probability.reset();
  sonar.false_alarm_probability.reset();
  return sonar;
}

/// The scores from `time` [s] on.
Metrics score_from(double time, const std::vector<TimedScan>& scans, const TrackingOutput& output) {
  const auto settled = std::find_if(scans.begin(), scans.end(), [time](const TimedScan& scan) {
    return core::seconds(scan.truth.utime) >= time;
  });
  TrackingOutput rest;
  rest.time_ms = output.time_ms;
  rest.tracks.assign(output.tracks.begin() + (settled - scans.begin()), output.tracks.end());
  return score({settled, scans.end()}, rest);
}

/// Mean number of tracks that are reported as confirmed.
double mean_tracks(const TrackingOutput& output) {
  double confirmed = 0.0;
  for (const auto& tracks : output.tracks)
    confirmed +=
        static_cast<double>(std::count_if(tracks.begin(), tracks.end(), [](const core::Track& track) {
          return track.status == core::TrackStatus::confirmed;
        }));
  return confirmed / static_cast<double>(output.tracks.size());
}

sonar_sim::Scene scene_of(const Cell& cell, std::uint64_t seed, int run) {
  return sea_scene({cell.parameters.text("condition"), cell.parameters.text("targets"),
                    cell.parameters.number("p_false_alarm"), cell.parameters.number("p_miss")},
                   seed, run);
}

std::unique_ptr<tracking::ScanPipeline> pipeline_of(const Cell& cell, const sonar_sim::Scene& scene,
                                                    std::uint64_t seed, int run) {
  tracking::ChainParams params;
  params.tracker.name = cell.method;
  params.tracker.report_standing = false;
  params.seed = run_seed(seed, run);
  return tracking::make_pipeline(params, told(cell, scene, seed, run));
}

/// What the methods of these cells, of one scene, have learnt of its clutter at the end of the first run;
/// those that learn none are left out.
std::vector<LearntClutter> learnt_clutter(const std::vector<Cell>& cells, const sonar_sim::Scene& scene,
                                          std::uint64_t seed) {
  const auto scans = simulate(scene, seed, 0);
  std::vector<LearntClutter> learnt;
  for (const Cell& cell : cells) {
    const auto pipeline = pipeline_of(cell, scene, seed, 0);
    if (!pipeline->learns_clutter()) continue;
    track(*pipeline, scans);
    if (auto grid = pipeline->clutter_grid()) learnt.push_back({cell.method, std::move(*grid)});
  }
  return learnt;
}

class Sea : public Experiment {
 public:
  std::string summary() const override {
    return "Trackers in a real sea: spill, patches, bottom, rocks, wall, lost scans, bursts, heavy tails, "
           "heading";
  }
  std::string scenario() const override { return "tools/scenarios/sea_CONDITION.yaml, targets drawn by run"; }
  std::string plot_script() const override { return "plot_sea.py"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const char* figures : kFigures)
      for (const char* targets : sea_targets())
        for (const double probability : kProbabilities)
          for (const char* condition : sea_conditions())
            for (const auto& method : tracking::tracker_names())
              cells.push_back(make_cell({condition, targets, probability, probability}, method, figures));
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto scene = scene_of(cell, seed, run);
    const auto scans = simulate(scene, seed, run);
    const auto pipeline = pipeline_of(cell, scene, seed, run);
    const auto output = track(*pipeline, scans);
    Metrics metrics = score_from(kSettled, scans, output);
    const Metrics later = score_from(kLater, scans, output);
    for (const char* name : {"ospa", "false_per_100s"})
      metrics[std::string(name) + "_later"] = later.at(name);
    metrics["num_tracks"] = mean_tracks(output);
    metrics["time_ms_median"] = median(output.times_ms);
    metrics["time_ms_p99"] = quantile(output.times_ms, kHighQuantile);
    return metrics;
  }

  /// Of each condition the true density of false returns and what was learnt of it in the first run.
  void write_extras(const Drawn& drawn) const override {
    for (const std::string condition : sea_conditions()) {
      const Parameters wanted{{"condition", condition},
                              {"targets", "near"},
                              {"p_false_alarm", kProbabilities[0]},
                              {"p_miss", kProbabilities[0]},
                              {"sensor_figures", "unknown"}};
      const Cell& cell = nearest_cell(drawn.cells, wanted);
      if (cell.parameters.text("condition") != condition) continue;
      const auto scene = scene_of(cell, drawn.seed, 0);
      const auto learnt = learnt_clutter(drawn.like(cell), scene, drawn.seed);
      if (learnt.empty()) continue;
      write_clutter(true_clutter(scene, drawn.seed, 0, learnt.front().grid), learnt,
                    drawn.directory + "/clutter_" + condition + ".csv");
      write_pictured(cell, drawn, 1, "clutter_" + condition);
    }
  }
};

}  // namespace

std::unique_ptr<Experiment> make_sea() {
  return std::make_unique<Sea>();
}

}  // namespace lookout::tools
