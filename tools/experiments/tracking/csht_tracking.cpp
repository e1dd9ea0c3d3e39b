#include "tools/experiments/tracking/csht_tracking.hpp"

#include <algorithm>
#include <string>

#include "core/files/recording.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/harness/paper_figures.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/harness/task_pool.hpp"
#include "tools/experiments/tracking/over_time.hpp"
#include "tools/experiments/tracking/perfect_association.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "tracking_table7.yaml";
constexpr const char* kPaperTable = "yan2018_tracking_tables.csv";
constexpr double kProbabilities[] = {0.1, 0.3, 0.5, 0.7};
constexpr double kOtherSigmas[] = {1.0, 2.0, 4.0, 5.0};
constexpr double kPaperSigma = 3.0;        ///< Of the 16 cells [m].
constexpr double kPaperProbability = 0.3;  ///< Of the other sigmas.
constexpr double kPaperWindow = 20.0;
constexpr double kLongWindow = 40.0;
constexpr double kLags[] = {5.0, 10.0};  ///< Delayed output of the trackers that have one [s].
constexpr int kFurtherRuns = 30;         ///< Of unknown figures and delayed output.
constexpr int kCostlyRuns = 20;          ///< Of csht under literal clutter, some 5 s a run.
constexpr int kPrintedRuns = 5;          ///< Of the printed steps there.

/// One point of the tables.
struct Point {
  double p_false_alarm = kPaperProbability;
  double p_miss = kPaperProbability;
  double sigma = kPaperSigma;
};

std::vector<Point> paper_points() {
  std::vector<Point> points;
  for (const double p_miss : kProbabilities) {
    for (const double p_false_alarm : kProbabilities) points.push_back({p_false_alarm, p_miss, kPaperSigma});
  }
  for (const double sigma : kOtherSigmas) points.push_back({kPaperProbability, kPaperProbability, sigma});
  return points;
}

/// The paper's steps to the letter, under the tracker of `csht`.
constexpr const char* kPrinted = "csht_printed";

bool uses_window(const std::string& method) {
  return method == "csht" || method == kPrinted;
}

/// Every tracker with its own estimator, and the printed estimator.
std::vector<std::string> methods() {
  std::vector<std::string> names = tracking::tracker_names();
  names.emplace_back(kPrinted);
  return names;
}

/// Trackers that use the sensor's probabilities, or estimate them where they are not told.
bool uses_figures(const std::string& method) {
  return method == "joint" || method == "jipda" || method == "gm_phd" || method == "pmbm";
}

/// The longer window serves high miss rates; the diagonal of the table shows its effect at the others.
bool in_long_window_row(const Point& point) {
  return point.sigma == kPaperSigma &&
         (point.p_miss == kProbabilities[3] || point.p_miss == point.p_false_alarm);
}

Cell make_cell(const std::string& method, const std::string& clutter, const Point& point, double window) {
  Cell cell;
  cell.method = method;
  cell.parameters = {{"clutter", clutter},
                     {"p_false_alarm", point.p_false_alarm},
                     {"p_miss", point.p_miss},
                     {"sigma", point.sigma},
                     {"window_scans", window},
                     {"sensor_figures", "known"},
                     {"lag_s", 0.0}};
  if (uses_window(method) && clutter == "literal")
    cell.max_runs = method == kPrinted ? kPrintedRuns : kCostlyRuns;
  return cell;
}

Cell variant(Cell cell, const std::string& parameter, const ParameterValue& value) {
  cell.parameters.set(parameter, value);
  cell.max_runs = std::min(cell.max_runs, kFurtherRuns);
  return cell;
}

/// The paper's case at one point, and what goes beyond it.
void add_cells(const std::string& method, const std::string& clutter, const Point& point,
               std::vector<Cell>& cells, std::vector<Cell>& further) {
  cells.push_back(make_cell(method, clutter, point, kPaperWindow));
  if (method == "csht" && in_long_window_row(point))
    further.push_back(make_cell(method, clutter, point, kLongWindow));
  if (!uses_figures(method)) return;
  further.push_back(variant(cells.back(), "sensor_figures", "unknown"));
  if (method != "joint") return;  // the others have no delayed output
  for (const double lag : kLags) further.push_back(variant(cells.back(), "lag_s", lag));
}

sonar_sim::Scene scene_of(const Cell& cell) {
  return load_variant(kScene,
                      {cell.parameters.number("p_false_alarm"), cell.parameters.number("p_miss"),
                       cell.parameters.number("sigma"), clutter_reading(cell.parameters.text("clutter"))});
}

std::unique_ptr<tracking::ScanPipeline> pipeline_of(const Cell& cell, const sonar_sim::Scene& scene,
                                                    std::uint64_t seed) {
  tracking::ChainParams params;
  params.tracker.name = cell.method == kPrinted ? "csht" : cell.method;
  if (cell.method == kPrinted) {
    params.estimator.name = kPrinted;
    params.tracker.own["csht"]["clutter.map.enabled"] = 0.0;  // the paper has no map
  }
  params.seed = seed;
  params.estimator.window_scans = static_cast<int>(cell.parameters.number("window_scans"));
  core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms[0]);
  if (cell.parameters.text("sensor_figures") == "unknown") {
    sonar.false_alarm_probability.reset();
    sonar.miss_probability.reset();
  }
  return tracking::make_pipeline(params, sonar);
}

/// Mean OSPA of the tracker that is told which detection is whose.
double bound(const std::vector<TimedScan>& scans, const core::SonarParams& sonar) {
  PerfectAssociation reference(sonar);
  tracking::Scorer scorer;
  for (const auto& scan : scans) scorer.add(scan.truth, reference.update(scan));
  return scorer.mean().position.total;
}

class CshtTracking : public Experiment {
 public:
  std::string summary() const override {
    return "[Yan2018] Tables 7-13: trackers on five targets that come and go, both clutter readings";
  }
  std::string scenario() const override { return std::string("tools/scenarios/") + kScene; }
  std::string plot_script() const override { return "plot_tracking.py"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells, further;
    for (const std::string clutter : {"literal", "light"}) {
      for (const auto& method : methods()) {
        for (const auto& point : paper_points()) add_cells(method, clutter, point, cells, further);
      }
    }
    const PaperFigures paper(kPaperTable);
    for (auto& cell : cells)
      cell.paper = paper.at(cell.method == kPrinted ? "csht" : cell.method, cell.parameters);
    cells.insert(cells.end(), further.begin(), further.end());
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const sonar_sim::Scene scene = scene_of(cell);
    const auto scans = simulate(scene, seed, run);
    const auto pipeline = pipeline_of(cell, scene, run_seed(seed, run));
    Metrics metrics = score(scans, track(*pipeline, scans, cell.parameters.number("lag_s")));
    metrics["bound"] = bound(scans, scene.platforms[0].sonar.params);
    return metrics;
  }

  void write_extras(const Drawn& drawn) const override {
    const Point middle{0.5, 0.5, kPaperSigma};  // the case of [Yan2018] Figs. 20 to 22
    const Cell cell = nearest_cell(drawn.cells, make_cell("csht", "light", middle, kPaperWindow).parameters);
    write_truth_of(simulate(scene_of(cell), drawn.seed, 0), drawn.directory + "/truth.csv");
    int runs = drawn.runs;
    for (const Cell& own : drawn.like(cell)) {
      runs = std::min(drawn.runs, own.max_runs);
      write_first_run(own, drawn);
      write_over_time(own, drawn, runs);
    }
    write_pictured(cell, drawn, runs, "run");
  }

 private:
  static void write_truth_of(const std::vector<TimedScan>& scans, const std::string& path) {
    std::vector<core::GroundTruth> truth;
    truth.reserve(scans.size());
    for (const auto& scan : scans) truth.push_back(scan.truth);
    core::write_truth(path, truth);
  }

  static TrackingOutput output_of(const Cell& cell, const std::vector<TimedScan>& scans, std::uint64_t seed,
                                  int run) {
    const auto pipeline = pipeline_of(cell, scene_of(cell), run_seed(seed, run));
    return track(*pipeline, scans, cell.parameters.number("lag_s"));
  }

  static void write_first_run(const Cell& cell, const Drawn& drawn) {
    const auto scans = simulate(scene_of(cell), drawn.seed, 0);
    const auto output = output_of(cell, scans, drawn.seed, 0);
    std::vector<core::TrackList> lists;
    for (std::size_t k = 0; k < output.tracks.size(); ++k)
      lists.push_back({scans[k].truth.utime, output.tracks[k]});
    core::write_tracks(drawn.directory + "/tracks_" + cell.method + ".csv", lists);
  }

  /// OSPA and its parts scan by scan, the mean over the runs with its interval.
  static void write_over_time(const Cell& cell, const Drawn& drawn, int runs) {
    std::vector<ScoredScans> all(static_cast<std::size_t>(runs));
    for_each_task(all.size(), drawn.jobs, [&](std::size_t run) {
      const auto scans = simulate(scene_of(cell), drawn.seed, static_cast<int>(run));
      all[run] = score_scans(scans, output_of(cell, scans, drawn.seed, static_cast<int>(run)));
    });
    write_mean_over_time(all, drawn.directory + "/ospa_" + cell.method + ".csv");
  }
};

}  // namespace

std::unique_ptr<Experiment> make_csht_tracking() {
  return std::make_unique<CshtTracking>();
}

}  // namespace lookout::tools
