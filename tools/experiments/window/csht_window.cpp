#include "tools/experiments/window/csht_window.hpp"

#include <chrono>

#include "core/files/csv.hpp"
#include "core/files/recording.hpp"
#include "csht/csht_estimator.hpp"
#include "csht/estimator_registry.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/cli/vote_matrices.hpp"
#include "tools/experiments/harness/paper_figures.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/nees.hpp"
#include "tools/experiments/tracking/sensor_knowledge.hpp"
#include "tools/experiments/window/joint_window.hpp"
#include "tools/experiments/window/least_squares_reference.hpp"
#include "tracking/metrics/ospa.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "window_table2.yaml";
constexpr int kWindowScans = 20;     // [Yan2018] section V.A
constexpr int kUnknownRuns = 100;    // Each watches a hundred scans of another scene first.
constexpr int kLongWindowRuns = 20;  // Of the methods that no long window helps.

using Points = std::vector<Eigen::Vector2d>;

/// Positions and velocities of a set of targets.
struct Elements {
  Points positions;
  Points velocities;
  void add(const Eigen::Vector4d& state) {
    positions.push_back(state.head<2>());
    velocities.push_back(state.tail<2>());
  }
};

Elements visible_truth(const core::GroundTruth& truth) {
  Elements elements;
  for (const auto& target : truth.targets) {
    if (!target.visible) continue;
    elements.positions.push_back(target.position);
    elements.velocities.push_back(target.velocity);
  }
  return elements;
}

/// What varies from cell to cell beside the method.
struct Setting {
  std::string clutter = "literal";
  double p_false_alarm = 0.3;
  double p_miss = 0.3;
  double sigma = 3.0;
  int window_scans = kWindowScans;
  std::string sensor_figures = "known";
};

Cell cell_of(const std::string& method, const PaperFigures& paper, const Setting& setting) {
  Cell cell;
  cell.method = method;
  cell.parameters = {{"p_false_alarm", setting.p_false_alarm},
                     {"p_miss", setting.p_miss},
                     {"sigma", setting.sigma},
                     {"window_scans", static_cast<double>(setting.window_scans)},
                     {"clutter", setting.clutter},
                     {"sensor_figures", setting.sensor_figures}};
  if (setting.window_scans == kWindowScans)
    cell.paper = paper.at(method == "sht" ? "sht" : "csht", cell.parameters);
  return cell;
}

/// The sixteen pairs of probabilities and the four other sigmas of [Yan2018] Tables 3 to 6.
void add_table(const std::string& method, const PaperFigures& paper, Setting setting,
               std::vector<Cell>& cells) {
  for (const double p_miss : {0.1, 0.3, 0.5, 0.7}) {
    for (const double p_false_alarm : {0.1, 0.3, 0.5, 0.7}) {
      setting.p_miss = p_miss;
      setting.p_false_alarm = p_false_alarm;
      cells.push_back(cell_of(method, paper, setting));
    }
  }
  setting.p_miss = setting.p_false_alarm = 0.3;
  for (const double sigma : {1.0, 2.0, 4.0, 5.0}) {
    setting.sigma = sigma;
    cells.push_back(cell_of(method, paper, setting));
  }
}

/// Longer windows: of `joint` the whole table, of the others the diagonal.
void add_long_windows(const PaperFigures& paper, std::vector<Cell>& cells) {
  for (const int window_scans : {40, 60}) {
    for (const char* clutter : {"light", "literal"})
      add_table("joint", paper, {.clutter = clutter, .window_scans = window_scans}, cells);
    for (const auto& method : csht::estimator_names()) {
      if (method == "joint") continue;
      for (const double p : {0.1, 0.3, 0.5, 0.7}) {
        cells.push_back(
            cell_of(method, paper, {.p_false_alarm = p, .p_miss = p, .window_scans = window_scans}));
        cells.back().max_runs = kLongWindowRuns;
      }
    }
  }
}

/// `joint` without the sensor's probabilities, and with wrong ones.
void add_unknown_figures(const PaperFigures& paper, std::vector<Cell>& cells) {
  const std::size_t first = cells.size();
  add_table("joint", paper, {.sensor_figures = "unknown"}, cells);
  for (std::size_t i = first; i < cells.size(); ++i) cells[i].max_runs = kUnknownRuns;
  for (const char* figures : {"half", "double"})
    for (const double p : {0.3, 0.5})
      cells.push_back(cell_of("joint", paper, {.p_false_alarm = p, .p_miss = p, .sensor_figures = figures}));
}

class CshtWindow : public Experiment {
 public:
  std::string summary() const override {
    return "Motion elements of three targets from one window of 20 scans ([Yan2018] Tables 3 to 6)";
  }
  std::string scenario() const override { return std::string("tools/scenarios/") + kScene; }
  std::string plot_script() const override { return "plot_window.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  void write_extras(std::uint64_t seed, const std::string& directory) const override;
};

std::vector<Cell> CshtWindow::cells() const {
  const PaperFigures paper("yan2018_window_tables.csv");
  std::vector<Cell> cells;
  for (const char* clutter : {"light", "literal"})
    for (const auto& method : csht::estimator_names()) add_table(method, paper, {.clutter = clutter}, cells);
  add_long_windows(paper, cells);
  add_unknown_figures(paper, cells);
  return cells;
}

/// The window's scans through the estimator; its answer to the newest, and what that one took.
struct Answer {
  std::vector<core::MotionElement> elements;
  double time_ms = 0.0;
};

Answer estimate(csht::MotionEstimator& estimator, const std::vector<TimedScan>& scans) {
  Answer answer;
  for (const auto& timed : scans) {
    const auto start = std::chrono::steady_clock::now();
    const auto elements = estimator.update(timed.posed);
    answer.time_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    answer.elements.assign(elements.begin(), elements.end());
  }
  return answer;
}

Metrics CshtWindow::run(const Cell& cell, std::uint64_t seed, int run) const {
  const auto& p = cell.parameters;
  const SceneVariant variant{p.number("p_false_alarm"), p.number("p_miss"), p.number("sigma"),
                             clutter_reading(p.text("clutter"))};
  csht::EstimatorParams params;
  params.use = csht::EstimatorUse::window;
  params.window_scans = static_cast<int>(p.number("window_scans"));
  auto scene = load_variant(kScene, variant);
  begin_earlier(params.window_scans * scene.platforms.front().sonar.params.scan_period - scene.duration,
                scene);
  const auto scans = simulate(scene, seed, run);
  const auto sonar = told_params(scene, variant, p.text("sensor_figures"), seed, run);
  params.first_estimate_scans = params.window_scans;
  const auto estimator =
      csht::make_estimator(cell.method, params, sonar, seed + static_cast<std::uint64_t>(run));
  const Answer answer = estimate(*estimator, scans);

  Elements found, reference;
  for (const auto& element : answer.elements) found.add(element.state());
  for (const auto& fit : least_squares_reference(scans, sonar)) reference.add(fit.state);
  const Elements truth = visible_truth(scans.back().truth);
  const bool count_right = found.positions.size() == truth.positions.size();
  tracking::Ospa ospa;
  Metrics metrics;
  metrics["position_ospa"] = ospa(truth.positions, found.positions).total;
  metrics["velocity_ospa"] = ospa(truth.velocities, found.velocities).total;
  if (count_right) metrics["velocity_ospa_count_right"] = metrics["velocity_ospa"];
  if (count_right && !answer.elements.empty())
    metrics["nees"] = mean_nees(scans.back().truth, answer.elements);
  metrics["count_correct"] = count_right ? 1.0 : 0.0;
  metrics["bound"] = ospa(truth.positions, reference.positions).total;
  metrics["velocity_bound"] = ospa(truth.velocities, reference.velocities).total;
  metrics["over_bound"] = metrics["position_ospa"].value - metrics["bound"].value;
  metrics["time_ms"] = answer.time_ms;
  return metrics;
}

/// The first window of the middle cell: light clutter for the methods that vote (detections, truth, what each
/// makes of it, the vote matrices), literal clutter for the joint estimator.
void CshtWindow::write_extras(std::uint64_t seed, const std::string& directory) const {
  const auto scene = load_variant(kScene, {0.3, 0.3, 3.0, sonar_sim::ClutterReading::light});
  const auto scans = simulate(scene, seed, 0);
  const auto sonar = sonar_sim::known_params(scene, scene.platforms.front());
  write_detections(scans, directory + "/window_detections.csv");
  std::vector<core::GroundTruth> truth;
  for (const auto& timed : scans) truth.push_back(timed.truth);
  core::write_truth(directory + "/window_truth.csv", truth);
  csht::CshtEstimator drawn(csht::CshtParams::window(), sonar);
  drawn.keep_snapshots();
  estimate(drawn, scans);
  write_vote_matrices(drawn, directory);
  for (const char* method : {"csht", "csht_printed", "sht"}) {
    csht::EstimatorParams params;
    params.use = csht::EstimatorUse::window;
    const auto estimator = csht::make_estimator(method, params, sonar, seed);
    const Answer answer = estimate(*estimator, scans);
    core::write_elements(directory + "/window_" + method + ".csv",
                         {{scans.back().posed.scan.utime, answer.elements}});
  }
  const auto literal = load_variant(kScene, {0.3, 0.3, 3.0, sonar_sim::ClutterReading::literal});
  write_joint_window(simulate(literal, seed, 0), sonar_sim::known_params(literal, literal.platforms.front()),
                     seed, directory);
}

}  // namespace

std::unique_ptr<Experiment> make_csht_window() {
  return std::make_unique<CshtWindow>();
}

}  // namespace lookout::tools
