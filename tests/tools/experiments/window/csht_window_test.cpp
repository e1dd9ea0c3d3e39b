#include "tools/experiments/window/csht_window.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "csht/csht_params.hpp"
#include "csht/estimator_registry.hpp"
#include "sonar_sim/scene.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {
namespace {

Cell cell_of(const std::string& method, double p_false_alarm, double p_miss, const std::string& clutter) {
  Cell cell;
  cell.method = method;
  cell.parameters = {{"p_false_alarm", p_false_alarm}, {"p_miss", p_miss},   {"sigma", 3.0},
                     {"window_scans", 20.0},           {"clutter", clutter}, {"sensor_figures", "known"}};
  return cell;
}

/// Mean of a metric over development seeds.
double mean(const Experiment& experiment, const Cell& cell, const std::string& metric, int runs) {
  double sum = 0.0;
  for (int run = 0; run < runs; ++run) sum += experiment.run(cell, 1000, run).at(metric).value;
  return sum / runs;
}

// The acceptance of the spine: the three targets of [Yan2018] Table 2 without clutter at P_M = .1, the count
// right in 95 % of the runs and the position within 1.25 x least squares.
TEST(CshtWindow, IsOnTheReferenceWithoutClutter) {
  const auto experiment = make_csht_window();
  const Cell cell = cell_of("csht", 0.0, 0.1, "light");
  EXPECT_GE(mean(*experiment, cell, "count_correct", 60), 0.95);
  EXPECT_LE(mean(*experiment, cell, "position_ospa", 60), 1.25 * mean(*experiment, cell, "bound", 60));
}

// Noise, quantisation, clutter and misses off, the estimator told sigma = 3 m: at most a fifth of a grid
// step.
TEST(CshtWindow, FindsTheExactSceneWithinAFifthOfAGridStep) {
  auto scene = load_variant("window_table2.yaml", {0.0, 0.0, 3.0, sonar_sim::ClutterReading::light});
  scene.platforms.front().sonar.echo_range_sigma = 0.0;
  scene.platforms.front().sonar.quantise_bearing = false;
  const auto scans = simulate(scene, 1000, 0);
  const core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms.front());
  csht::EstimatorParams params;
  params.use = csht::EstimatorUse::window;
  const auto estimator = csht::make_estimator("csht", params, sonar, 1);
  std::span<const core::MotionElement> elements;
  for (const auto& timed : scans) elements = estimator->update(timed.posed);
  ASSERT_EQ(elements.size(), 3U);
  const csht::HoughGrid grid = csht::csht_grid(csht::CshtParams::window(), sonar);
  for (const auto& target : scans.back().truth.targets) {
    double nearest = 1e9, velocity_error = 1e9;
    for (const auto& element : elements) {
      if ((element.position - target.position).norm() >= nearest) continue;
      nearest = (element.position - target.position).norm();
      velocity_error = (element.velocity - target.velocity).norm();
    }
    EXPECT_LT(nearest, 0.2 * grid.intercept_step);
    EXPECT_LT(velocity_error, 0.2 * grid.velocity_step);
  }
}

// Cluttered cells: the means of docs/results/2026-11-30-csht-window.md (1.27, 2.0 and 2.8 m) plus two
// standard errors of as few runs as these.
TEST(CshtWindow, StaysWithinItsFiguresInClutter) {
  const auto experiment = make_csht_window();
  EXPECT_LE(mean(*experiment, cell_of("csht", 0.3, 0.3, "light"), "position_ospa", 30), 1.8);
  EXPECT_LE(mean(*experiment, cell_of("csht", 0.5, 0.5, "light"), "position_ospa", 30), 3.2);
  EXPECT_LE(mean(*experiment, cell_of("csht", 0.1, 0.3, "literal"), "position_ospa", 20), 3.5);
}

// On the grid of csht, made for Gaussian votes, the standard Hough transform has a velocity OSPA of 8 m/s
// here.
TEST(CshtWindow, TheStandardTransformHasAGridOfItsOwn) {
  EXPECT_LE(mean(*make_csht_window(), cell_of("sht", 0.1, 0.1, "light"), "velocity_ospa", 40), 5.5);
}

// 20 points of the paper's tables, three methods, both readings; each with the paper's figure.
TEST(CshtWindow, HoldsThePapersCells) {
  const auto cells = make_csht_window()->cells();
  int faithful = 0;
  for (const auto& cell : cells) {
    if (cell.method != "csht" || cell.parameters.number("window_scans") != 20.0) continue;
    if (cell.parameters.has("sensor_figures") && cell.parameters.text("sensor_figures") != "known") continue;
    ++faithful;
    EXPECT_TRUE(cell.paper.contains("position_ospa"));
  }
  EXPECT_EQ(faithful, 40);
}

// `--only method=sht --only p_miss=0.5` leaves one cell: its window is drawn, that of no other method.
TEST(CshtWindow, DrawsTheCellsThatAreLeft) {
  const tests::TemporaryDirectory folder;
  Drawn drawn;
  drawn.seed = 1000;
  drawn.cells = {cell_of("sht", 0.1, 0.5, "light")};
  drawn.directory = folder.path();
  make_csht_window()->write_extras(drawn);
  EXPECT_TRUE(std::filesystem::exists(folder.file("window_sht.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("window_csht.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("joint_elements.csv")));
  const auto pictured = nlohmann::json::parse(std::ifstream(folder.file("pictured_window.json")));
  EXPECT_EQ(pictured["parameters"]["p_miss"], 0.5);
}

}  // namespace
}  // namespace lookout::tools
