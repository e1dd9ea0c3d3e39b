#include "tools/experiments/window/csht_ladder.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/window/window_run.hpp"

namespace lookout::tools {
namespace {

// Every rung takes a whole window of [Yan2018] Table 2 without clutter, and finds something in it.
TEST(CshtLadder, EveryRungEstimates) {
  const auto scene = load_variant("window_table2.yaml", {0.0, 0.1, 3.0, sonar_sim::ClutterReading::light});
  const auto sonar = sonar_sim::known_params(scene, scene.platforms.front());
  const auto scans = simulate(scene, 1000, 0);
  for (const auto& name : ladder_rungs()) {
    const LadderEstimator rung = make_rung(name, static_cast<int>(scans.size()), sonar);
    EXPECT_FALSE(estimate_window(*rung.estimator, scans).elements.empty()) << name;
    EXPECT_GT(rung.classes ? rung.classes() : 1, 0) << name;
  }
}

/// Mean position OSPA of a rung over ten windows of the middle cell, light clutter, development seed.
double mean_ospa(const std::string& name) {
  const auto scene = load_variant("window_table2.yaml", {0.3, 0.3, 3.0, sonar_sim::ClutterReading::light});
  const auto sonar = sonar_sim::known_params(scene, scene.platforms.front());
  double sum = 0.0;
  for (int run = 0; run < 10; ++run) {
    const auto scans = simulate(scene, 1000, run);
    const LadderEstimator rung = make_rung(name, static_cast<int>(scans.size()), sonar);
    sum += score_window(scans, sonar, estimate_window(*rung.estimator, scans)).at("position_ospa").value;
  }
  return sum / 10.0;
}

// The whole is better than the classes alone, and those than the printed steps, by more than any chance (a
// standard error is about .7 m).
TEST(CshtLadder, EachPartOfTheLadderHelps) {
  EXPECT_LT(mean_ospa("E") + 1.0, mean_ospa("C"));
  EXPECT_LT(mean_ospa("C") + 3.0, mean_ospa("A"));
}

TEST(CshtLadder, RefusesAnUnknownRung) {
  EXPECT_THROW(make_rung("F", 20, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
