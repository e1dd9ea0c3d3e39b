#include "fusion/learned_geometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "core/random.hpp"
#include "fusion/methods/support_degree_fusion.hpp"
#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::group;
using testing::tracklet;

struct Sensor {
  Eigen::Vector2d position;
  double range_sigma;
  double bearing_sigma;
  double bearing_bias = 0.0;
};

LocalTrack look(const Sensor& sensor, std::int32_t id, const Eigen::Vector2d& target, core::Random& random) {
  const Eigen::Vector2d sight = target - sensor.position;
  const double range = sight.norm() + random.gaussian(sensor.range_sigma);
  const double azimuth =
      std::atan2(sight.y(), sight.x()) + sensor.bearing_bias + random.gaussian(sensor.bearing_sigma);
  const Eigen::Vector2d seen =
      sensor.position + range * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
  return tracklet(id, {seen.x(), seen.y(), 1.0, 0.0}, sensor.position);
}

/// Mean squared error of the last 50 of 150 updates, six targets about the origin; the mean of the squared
/// position errors under the stated covariances over their two degrees too.
struct Accuracy {
  double squared = 0.0;
  double nees = 0.0;
};
Accuracy accuracy_of(FusionMethod& method, const std::vector<Sensor>& sensors) {
  core::Random random(1001);
  Accuracy result;
  for (int k = 0; k < 150; ++k) {
    std::vector<Eigen::Vector2d> targets;
    std::vector<std::vector<LocalTrack>> tracks(6);
    std::vector<TrackGroup> groups;
    for (auto& seen : tracks) {
      targets.push_back({random.uniform(-40, 40), random.uniform(-40, 40)});
      for (std::size_t i = 0; i < sensors.size(); ++i)
        seen.push_back(look(sensors[i], static_cast<std::int32_t>(i) + 1, targets.back(), random));
      groups.push_back(group({targets.back().x(), targets.back().y(), 1, 0}, seen));
    }
    const auto fused = method.fuse(groups);
    if (k < 100) continue;
    for (std::size_t g = 0; g < targets.size(); ++g) {
      const Eigen::Vector2d error = fused[g].state.head<2>() - targets[g];
      const Eigen::Matrix2d covariance = fused[g].covariance.topLeftCorner<2, 2>();
      result.squared += error.squaredNorm() / 300.0;
      result.nees += 0.5 * error.dot(covariance.inverse() * error) / 300.0;
    }
  }
  return result;
}

double learn(LearnedGeometry& method, const std::vector<Sensor>& sensors) {
  return accuracy_of(method, sensors).squared;
}

const std::vector<Sensor> kFour{{{-100, -100}, 4.0, 0.005},
                                {{-100, 100}, 4.0, 0.005},
                                {{100, 100}, 4.0, 0.005},
                                {{100, -100}, 4.0, 0.005}};

TEST(LearnedGeometry, FindsTheVariancesOfEqualSensors) {
  LearnedGeometry method({});
  learn(method, kFour);
  // The truth of the scene, within a quarter: 25 updates of six targets pooled.
  EXPECT_NEAR(std::sqrt(method.quality(1).range_variance), 4.0, 1.0);
  EXPECT_NEAR(std::sqrt(method.quality(1).bearing_variance), 0.005, 0.002);
}

TEST(LearnedGeometry, FindsTheBadSensor) {
  auto sensors = kFour;
  sensors[2].range_sigma *= 5.0;
  sensors[2].bearing_sigma *= 5.0;
  LearnedGeometry method({});
  learn(method, sensors);
  EXPECT_GT(method.quality(3).bearing_variance, 6.0 * method.quality(1).bearing_variance);
  EXPECT_GT(method.quality(3).range_variance, 6.0 * method.quality(1).range_variance);
}

TEST(LearnedGeometry, ShutsOutABiasedSensor) {
  auto biased = kFour;
  biased[2].bearing_bias = core::radians(5.0);  // 12 m across at 140 m.
  LearnedGeometry method({}), without({});
  const double with_bias = learn(method, biased);
  biased.erase(biased.begin() + 2);
  EXPECT_LT(with_bias, 1.5 * learn(without, biased));  // About as good as without that sensor.
}

TEST(LearnedGeometry, BeatsTheMeanFarWhereEllipsesAreLong) {
  LearnedGeometry method({});
  // Four sensors at 140 m: across 0.7 m, along 4 m. The information of two pairs at right angles is
  // 2 (1/0.49 + 1/16) in each direction: 0.49 m^2 in all; the mean has (0.49 + 16) / 4 = 4.1 m^2.
  EXPECT_LT(learn(method, kFour), 1.15 * 0.49);
}

// 300 errors of two degrees: the mean of their squares has a standard error of 1/sqrt(300) = 0.06; what is
// learned of 25 updates adds as much again.
TEST(LearnedGeometry, StatesWhatItsErrorsAre) {
  LearnedGeometry learned({});
  EXPECT_NEAR(accuracy_of(learned, kFour).nees, 1.0, 0.3);
}

TEST(LearnedGeometry, ScalarWeightsStateWhatTheirErrorsAreToo) {
  MeanFusion mean;
  SupportDegreeFixed repaired;
  EXPECT_NEAR(accuracy_of(mean, kFour).nees, 1.0, 0.3);
  EXPECT_NEAR(accuracy_of(repaired, kFour).nees, 1.0, 0.4);  // Its weights depend on the errors.
}

TEST(LearnedGeometry, FindsTheErrorOfVelocities) {
  LearnedGeometry method({});
  core::Random random(1003);
  for (int k = 0; k < 200; ++k) {
    std::vector<LocalTrack> tracks;
    for (std::int32_t id : {1, 2, 3})
      tracks.push_back(tracklet(
          id, {random.gaussian(1.0), random.gaussian(1.0), random.gaussian(2.0), random.gaussian(0.2)},
          {-100.0, 0.0}));
    const std::vector<TrackGroup> groups{group({0, 0, 0, 0}, tracks)};
    method.fuse(groups);
  }
  // 2 m/s along the line of sight, .2 m/s across it at 100 m; 25 updates of three nodes.
  EXPECT_NEAR(std::sqrt(method.quality(1).range_rate_variance), 2.0, 0.6);
  EXPECT_NEAR(std::sqrt(method.quality(1).bearing_rate_variance), 0.002, 0.0006);
}

TEST(LearnedGeometry, OneNodeAloneIsTakenAsItIs) {
  LearnedGeometry method({});
  const std::vector<LocalTrack> tracks{tracklet(1, {30, 40, 1, -1})};
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  for (int k = 0; k < 30; ++k)
    EXPECT_NEAR((method.fuse(groups).front().state - Eigen::Vector4d(30, 40, 1, -1)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(method.quality(1).range_variance, 9.0, 1e-12);  // Nothing was learned: the starting value.
}

TEST(LearnedGeometry, CollinearSensorsAndATargetOnASensorStayFinite) {
  LearnedGeometry method({});
  const std::vector<LocalTrack> line{tracklet(1, {100, 0, 1, 0}, {0, 0}),
                                     tracklet(2, {102, 0, 1, 0}, {200, 0}),
                                     tracklet(3, {101, 0, 1, 0}, {101, 0})};
  const std::vector<TrackGroup> groups{group({100, 0, 1, 0}, line)};
  for (int k = 0; k < 50; ++k) {
    const FusedState& fused = method.fuse(groups).front();
    ASSERT_TRUE(fused.state.allFinite() && fused.covariance.allFinite());
    EXPECT_NEAR(fused.state.x(), 101.0, 1.01);  // Between the sensors' estimates.
    EXPECT_NEAR(fused.state.y(), 0.0, 1e-6);
  }
}

TEST(LearnedGeometry, OldEstimatesThatAgreeLeaveFiniteWeights) {
  // Four seconds old, 0.3 m/s of drift each, and alike to the micrometre: all of the difference is age's,
  // none of it the nodes' own. A variance of zero would divide by zero.
  LearnedGeometry method({});
  const std::vector<LocalTrack> alike{tracklet(1, {30, 40, 1, 0}, {0, 0}),
                                      tracklet(2, {30, 40.000001, 1, 0}, {90, 0})};
  std::vector<TrackGroup> groups{group({30, 40, 1, 0}, alike)};
  groups[0].utime = core::microseconds(5.0);
  for (int k = 0; k < 200; ++k) ASSERT_TRUE(method.fuse(groups).front().state.allFinite()) << k;
  EXPECT_GT(method.quality(1).range_variance, 0.0);
  EXPECT_LT(method.quality(1).range_variance, 9.0);  // They agree better than they were thought to.
}

TEST(LearnedGeometry, TurnsWithTheScene) {
  LearnedGeometry method({}), turned({});
  const std::vector<LocalTrack> tracks{tracklet(1, {30, 40, 1, 2}, {0, 0}),
                                       tracklet(2, {33, 41, 2, 1}, {90, 0})};
  // A quarter turn: (north, east) -> (-east, north).
  const std::vector<LocalTrack> quarter{tracklet(1, {-40, 30, -2, 1}, {0, 0}),
                                        tracklet(2, {-41, 33, -1, 2}, {0, 90})};
  const std::vector<TrackGroup> groups{group({30, 40, 1, 2}, tracks)};
  const std::vector<TrackGroup> turned_groups{group({-40, 30, -2, 1}, quarter)};
  const Eigen::Vector4d a = method.fuse(groups).front().state, b = turned.fuse(turned_groups).front().state;
  EXPECT_NEAR((b - Eigen::Vector4d(-a(1), a(0), -a(3), a(2))).norm(), 0.0, 1e-9);
}

TEST(LearnedGeometry, RefusesBadParameters) {
  LearnedGeometryParams params;
  params.window_updates = 0;
  EXPECT_THROW(LearnedGeometry{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
