#include "tools/experiments/initiation/initiation_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lookout::tools {
namespace {

core::Random dice(std::uint64_t run = 0) {
  return core::Random(1000, core::RandomStream::experiment, run);
}

int plots_of(const InitiationScene& scene, int target) {
  return static_cast<int>(std::count(scene.target_of.begin(), scene.target_of.end(), target));
}

TEST(FanScene, IdealPlotsLieOnTheCourses) {
  auto random = dice();
  FanSceneParams params;
  params.situation = "I";
  const auto scene = fan_scene(params, random);
  ASSERT_EQ(scene.scans.size(), 7u);
  EXPECT_EQ(scene.num_targets, 3);
  EXPECT_EQ(plots_of(scene, -1), 0);
  // [Fan2018] section V.A: target 1 starts at (300, 400) m with (280, 49) m/s; 12 s later:
  EXPECT_NEAR(scene.scans[6][0].position.x(), 300.0 + 12.0 * 280.0, 1e-9);
  EXPECT_NEAR(scene.scans[6][0].position.y(), 400.0 + 12.0 * 49.0, 1e-9);
}

TEST(FanScene, ClutterIsPoissonOfItsMean) {
  double sum = 0.0, squares = 0.0;
  constexpr int kRuns = 200;
  for (int run = 0; run < kRuns; ++run) {
    auto random = dice(static_cast<std::uint64_t>(run));
    FanSceneParams params;
    params.situation = "III";
    params.clutter_per_scan = 20.0;
    const auto scene = fan_scene(params, random);
    const double number = plots_of(scene, -1);
    sum += number;
    squares += number * number;
  }
  const double mean = sum / kRuns, variance = squares / kRuns - mean * mean;
  EXPECT_NEAR(mean, 140.0, 4.0 * std::sqrt(140.0 / kRuns));         // seven scans of twenty
  EXPECT_NEAR(variance / mean, 1.0, 4.0 * std::sqrt(2.0 / kRuns));  // Poisson: variance = mean
}

TEST(RealScene, HoldsTheThreePublishedTracks) {
  auto random = dice();
  const auto scene = real_scene(0.0, 150.0, random);
  EXPECT_EQ(scene.num_targets, 3);
  EXPECT_EQ(scene.scans[0][0].position, Eigen::Vector2d(-23793.0, 24841.0));  // Table 3, first row
  EXPECT_EQ(plots_of(scene, 0), static_cast<int>(scene.scans.size()));
}

TEST(ZengScene, MissesAtTheAskedRate) {
  int plots = 0;
  for (std::uint64_t run = 0; run < 100; ++run) {
    auto random = dice(run);
    const auto scene = zeng_scene({.clutter_per_scan = 0.0, .detection_probability = 0.9}, random);
    plots += static_cast<int>(scene.target_of.size());
  }
  // 100 runs x 4 scans x 5 targets: a standard deviation of 13.4 plots.
  EXPECT_NEAR(plots, 1800, 4 * 13.4);
}

TEST(ZengScene, WindowHoldsTheScansInOrder) {
  auto random = dice();
  const auto scene = zeng_scene({}, random);
  const auto window = scene.window();
  ASSERT_EQ(window.num_scans(), 4);
  for (int scan = 0; scan < 4; ++scan)
    EXPECT_EQ(window.size(scan), static_cast<int>(scene.scans[static_cast<std::size_t>(scan)].size()));
}

}  // namespace
}  // namespace lookout::tools
