#include "tools/experiments/window/csht_window.hpp"

#include "core/files/recording.hpp"
#include "csht/csht_estimator.hpp"
#include "csht/estimator_registry.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/cli/vote_matrices.hpp"
#include "tools/experiments/harness/paper_figures.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/sensor_knowledge.hpp"
#include "tools/experiments/window/joint_window.hpp"
#include "tools/experiments/window/window_run.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "window_table2.yaml";
constexpr int kWindowScans = 20;     // [Yan2018] section V.A
constexpr int kUnknownRuns = 100;    // Each watches a hundred scans of another scene first.
constexpr int kLongWindowRuns = 20;  // Of the methods that no long window helps.

/// What varies from cell to cell beside the method.
struct Setting {
  std::string clutter = "literal";
  double p_false_alarm = 0.3;
  double p_miss = 0.3;
  double sigma = 3.0;
  int window_scans = kWindowScans;
  std::string sensor_figures = "known";
};

Cell cell_of(const std::string& method, const Setting& setting) {
  Cell cell;
  cell.method = method;
  cell.parameters = {{"p_false_alarm", setting.p_false_alarm},
                     {"p_miss", setting.p_miss},
                     {"sigma", setting.sigma},
                     {"window_scans", static_cast<double>(setting.window_scans)},
                     {"clutter", setting.clutter},
                     {"sensor_figures", setting.sensor_figures}};
  return cell;
}

Cell cell_of(const std::string& method, const PaperFigures& paper, const Setting& setting) {
  Cell cell = cell_of(method, setting);
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
  void write_extras(const Drawn& drawn) const override;
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

SceneVariant variant_of(const Cell& cell) {
  const auto& p = cell.parameters;
  return {p.number("p_false_alarm"), p.number("p_miss"), p.number("sigma"),
          clutter_reading(p.text("clutter"))};
}

Metrics CshtWindow::run(const Cell& cell, std::uint64_t seed, int run) const {
  const auto& p = cell.parameters;
  const SceneVariant variant = variant_of(cell);
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
  return score_window(scans, sonar, estimate_window(*estimator, scans));
}

/// One window of a cell: its scene as long as the window, the scans of run 0.
struct DrawnWindow {
  sonar_sim::Scene scene;
  std::vector<TimedScan> scans;
  core::SonarParams sonar;
};

DrawnWindow window_of(const Cell& cell, std::uint64_t seed) {
  DrawnWindow window{load_variant(kScene, variant_of(cell)), {}, {}};
  const double period = window.scene.platforms.front().sonar.params.scan_period;
  begin_earlier(cell.parameters.number("window_scans") * period - window.scene.duration, window.scene);
  window.scans = simulate(window.scene, seed, 0);
  window.sonar = sonar_sim::known_params(window.scene, window.scene.platforms.front());
  return window;
}

void write_window(const DrawnWindow& window, const std::string& directory) {
  write_detections(window.scans, directory + "/window_detections.csv");
  std::vector<core::GroundTruth> truth;
  for (const auto& timed : window.scans) truth.push_back(timed.truth);
  core::write_truth(directory + "/window_truth.csv", truth);
}

void write_answer(const Cell& cell, const DrawnWindow& window, const Drawn& drawn) {
  csht::EstimatorParams params;
  params.use = csht::EstimatorUse::window;
  params.window_scans = static_cast<int>(cell.parameters.number("window_scans"));
  const auto estimator = csht::make_estimator(cell.method, params, window.sonar, drawn.seed);
  const WindowAnswer answer = estimate_window(*estimator, window.scans);
  core::write_elements(drawn.directory + "/window_" + cell.method + ".csv",
                       {{window.scans.back().posed.scan.utime, answer.elements}});
}

/// What every method but `joint` makes of the drawn cell that is nearest to (.3, .3), light clutter: the case
/// of [Yan2018] Fig. 8 to 15. The vote matrices are those of `csht`.
void write_voting_window(const Drawn& drawn) {
  Drawn voting = drawn;
  std::erase_if(voting.cells, [](const Cell& cell) { return cell.method == "joint"; });
  if (voting.cells.empty()) return;
  const Cell cell = nearest_cell(voting.cells, cell_of("csht", {.clutter = "light"}).parameters);
  const DrawnWindow window = window_of(cell, drawn.seed);
  write_window(window, drawn.directory);
  csht::CshtParams params = csht::CshtParams::window();
  params.window_scans = static_cast<int>(cell.parameters.number("window_scans"));
  csht::CshtEstimator estimator(params, window.sonar);
  estimator.keep_snapshots();
  estimate_window(estimator, window.scans);
  write_vote_matrices(estimator, drawn.directory);
  for (const Cell& own : voting.like(cell)) write_answer(own, window, drawn);
  write_pictured(cell, drawn, 1, "window");
}

/// The joint estimator on the drawn cell that is nearest to (.3, .3), literal clutter.
void write_joint_picture(const Drawn& drawn) {
  const std::vector<Cell> cells = drawn.of_method("joint");
  if (cells.empty()) return;
  const Cell& cell = nearest_cell(cells, cell_of("joint", {.clutter = "literal"}).parameters);
  const DrawnWindow window = window_of(cell, drawn.seed);
  write_joint_window(window.scans, window.sonar, drawn.seed, drawn.directory);
  write_pictured(cell, drawn, 1, "joint");
}

void CshtWindow::write_extras(const Drawn& drawn) const {
  write_voting_window(drawn);
  write_joint_picture(drawn);
}

}  // namespace

std::unique_ptr<Experiment> make_csht_window() {
  return std::make_unique<CshtWindow>();
}

}  // namespace lookout::tools
