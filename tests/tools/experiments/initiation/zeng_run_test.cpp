#include "tools/experiments/initiation/zeng_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/frames.hpp"

namespace lookout::tools {
namespace {

Cell vct_cell() {
  return zeng_cell({"vct", "", 4, 4, 4, 120, 1.0});
}

TEST(ZengRun, ACellSaysMethodAndScene) {
  Cell cell = vct_cell();
  cell.parameters.set("max_turn_rate_deg", 2.0);
  cell.parameters.set("turn_rate_deg", 1.0);
  cell.parameters.set("told_noise", 2.0);
  EXPECT_EQ(zeng_config(cell).min_plots, 4);
  EXPECT_NEAR(*zeng_config(cell).max_turn_rate, core::radians(2.0), 1e-15);
  EXPECT_NEAR(zeng_params(cell).turn_rate, core::radians(1.0), 1e-15);
  EXPECT_EQ(zeng_params(cell).told_noise, 2.0);
}

TEST(ZengRun, EachMethodHasItsThreshold) {
  tracking::InitiatorConfig config;
  set_threshold("vct", 0.3, config);
  set_threshold("modified_logic", 0.9, config);
  set_threshold("ht", 0.8, config);
  EXPECT_EQ(config.max_false_tracks, 0.3);
  EXPECT_EQ(config.gate_probability, 0.9);
  EXPECT_EQ(config.peak_threshold, 0.8);
  EXPECT_THROW(set_threshold("unknown", 1.0, config), std::invalid_argument);
}

/// [Zeng2023]'s radar sees a target go straight; with a steady turn of two degrees a second its third step
/// has turned by 20 degrees from the first.
TEST(ZengScene, TargetsTurnAndSpeedUp) {
  ZengSceneParams params;
  params.clutter_per_scan = 0.0;
  params.azimuth_sigma = 1e-9;
  params.range_sigma = 1e-3;
  params.turn_rate = core::radians(2.0);
  core::Random random(1001);
  const auto scene = zeng_scene(params, random);
  const auto step = [&](std::size_t k) -> Eigen::Vector2d {
    return scene.scans[k + 1][0].position - scene.scans[k][0].position;
  };
  const double turned = std::atan2(step(2).y(), step(2).x()) - std::atan2(step(0).y(), step(0).x());
  EXPECT_NEAR(turned, core::radians(20.0), 0.03);  // Accelerations of 1 m/s^2 besides.
  params.turn_rate = 0.0;
  params.acceleration = 5.0;
  core::Random again(1001);
  const auto faster = zeng_scene(params, again);
  const Eigen::Vector2d way = faster.scans[3][0].position - faster.scans[0][0].position;
  EXPECT_NEAR(way.x(), 15.0 * 500.0 + 0.5 * 5.0 * 225.0, 150.0);
}

TEST(ZengScene, ClustersHoldAsManyPlots) {
  ZengSceneParams params;
  params.clustered = true;
  double plots = 0.0;
  for (std::uint64_t run = 0; run < 100; ++run) {
    core::Random random(1000, core::RandomStream::experiment, run);
    plots += static_cast<double>(zeng_scene(params, random).target_of.size());
  }
  // 4 scans of 120 and 5 of targets; clusters of five: sigma of the mean of 100 runs is sqrt(480 * 5 / 100)
  // = 4.9.
  EXPECT_NEAR(plots / 100.0, 4.0 * 125.0, 20.0);
}

/// On the paper's own scene: what it says of roots, and how much the reading matters.
TEST(ZengRun, RootsThatNoRootClaimedFindMoreTargets) {
  const auto found = [](const char* variant) {
    const Cell cell = zeng_cell({"ag_fht", variant, 4, 4, 0, 120, 1.0});
    double sum = 0.0;
    for (int run = 0; run < 60; ++run)
      sum += measure_on_zeng(cell, 1000, run, TrueTrack::strict).at("p2").value;
    return sum / 60.0;
  };
  EXPECT_GT(found("text"), found("text_outside_gates") + 0.02);
  EXPECT_GT(found("text"), 0.9);
}

/// A target that turns at two degrees a second, with and without ways of turning; and the straight one.
TEST(ZengRun, VctThatFollowsTurnsHoldsThemAndTheStraightFigures) {
  const auto found = [](double rate, double followed) {
    Cell cell = vct_cell();
    cell.parameters.set("turn_rate_deg", rate);
    if (followed > 0.0) cell.parameters.set("max_turn_rate_deg", followed);
    double sum = 0.0;
    for (int run = 0; run < 60; ++run)
      sum += measure_on_zeng(cell, 1000, run, TrueTrack::share).at("p2").value;
    return sum / 60.0;
  };
  EXPECT_LT(found(2.0, 0.0), 0.3);
  EXPECT_GE(found(2.0, 3.0), 0.95);
  EXPECT_GE(found(0.0, 3.0), 0.97);
}

}  // namespace
}  // namespace lookout::tools
