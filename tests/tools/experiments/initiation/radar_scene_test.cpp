#include "tools/experiments/initiation/radar_scene.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <stdexcept>

namespace lookout::tools {
namespace {

std::vector<RadarScan> scene(const RadarSceneParams& params, std::uint64_t run = 0) {
  core::Random random(1000, core::RandomStream::experiment, run);
  return simulate_radars(params, random);
}

TEST(RadarScene, EveryRadarReportsEveryTargetEveryScan) {
  const auto scans = scene({});
  ASSERT_EQ(scans.size(), static_cast<std::size_t>(kRadarScans));
  for (const auto& scan : scans) ASSERT_EQ(scan.estimates.size(), 16u);
  EXPECT_EQ(scans[0].estimates[5].node_id, 2);
  EXPECT_EQ(scans[0].estimates[5].track_id, 2);
  EXPECT_EQ(scans[3].estimates[0].utime, 6'000'000);
}

TEST(RadarScene, TargetsFlyStraightWithoutProcessNoise) {
  RadarSceneParams params;
  params.process_noise = 0.0;
  const auto scans = scene(params);
  // [Li2018] section 5: 200 m/s on both axes for 25 periods of 2 s.
  EXPECT_NEAR(scans.back().truth[0].x(), 9000.0 + 50.0 * 200.0, 1e-6);
  EXPECT_NEAR(scans.back().truth[3].y(), 18000.0 - 50.0 * 200.0, 1e-6);
}

/// Root mean square error of radar `node` over the later half of 40 runs, target 1.
double error_of(const RadarSceneParams& params, int node) {
  double sum = 0.0;
  int number = 0;
  for (std::uint64_t run = 0; run < 40; ++run) {
    const auto scans = scene(params, run);
    for (std::size_t k = scans.size() / 2; k < scans.size(); ++k) {
      const auto& estimate = scans[k].estimates[static_cast<std::size_t>(4 * (node - 1))];
      sum += (estimate.state.head<2>() - scans[k].truth[0].head<2>()).squaredNorm();
      ++number;
    }
  }
  return std::sqrt(sum / number);
}

TEST(RadarScene, OnlyTheFaultyRadarIsWorse) {
  RadarSceneParams worse;
  worse.fault = RadarFault::worse;
  EXPECT_EQ(error_of(worse, 1), error_of({}, 1));  // the draws of the others do not depend on the fault
  EXPECT_GT(error_of(worse, kFaultyRadar), 2.0 * error_of({}, kFaultyRadar));
}

TEST(RadarScene, TheFiltersCovarianceIsWhatTheirErrorIs) {
  constexpr int kRuns = 100;
  double nees = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const auto last = scene({.azimuth_sigma = 0.005}, static_cast<std::uint64_t>(run)).back();
    for (std::size_t target = 0; target < 4; ++target) {  // of radar 1: radars share the targets' noise
      const auto& estimate = last.estimates[target];
      const Eigen::Vector4d error = estimate.state - last.truth[target];
      nees += error.dot(estimate.covariance->inverse() * error);
    }
  }
  // Chi-square of four degrees of freedom: mean 4, variance 8.
  EXPECT_NEAR(nees / (4 * kRuns), 4.0, 3.0 * std::sqrt(8.0 / (4 * kRuns)));
}

TEST(RadarScene, RefusesWhatItCannotSimulate) {
  EXPECT_THROW(scene({.azimuth_sigma = 0.0}), std::invalid_argument);
  EXPECT_THROW(scene({.num_targets = 5}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
