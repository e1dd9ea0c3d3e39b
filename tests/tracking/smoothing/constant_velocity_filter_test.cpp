#include "tracking/smoothing/constant_velocity_filter.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

core::Track track_of(const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) {
  core::Track track;
  track.state = state;
  track.covariance = covariance;
  return track;
}

TEST(ConstantVelocityFilter, PredictionMovesByVelocityTimesTime) {
  core::Track track = track_of({1.0, 2.0, 3.0, -4.0}, Eigen::Matrix4d::Identity());
  predict(track, 0.5, {.acceleration_sigma = 0.0});
  EXPECT_TRUE(track.state.isApprox(Eigen::Vector4d(2.5, 0.0, 3.0, -4.0)));
  EXPECT_NEAR(track.covariance(0, 0), 1.25, 1e-12);  // position variance + time^2 x velocity variance
  EXPECT_NEAR(track.covariance(0, 2), 0.5, 1e-12);
}

TEST(ConstantVelocityFilter, AccelerationAddsItsNoise) {
  core::Track track = track_of(Eigen::Vector4d::Zero(), Eigen::Matrix4d::Zero());
  predict(track, 2.0, {.acceleration_sigma = 3.0});
  EXPECT_NEAR(track.covariance(0, 0), 36.0, 1e-12);  // (3 x 2^2 / 2)^2
  EXPECT_NEAR(track.covariance(3, 3), 36.0, 1e-12);  // (3 x 2)^2
}

TEST(ConstantVelocityFilter, UpdateWeighsByVariance) {
  core::Track track = track_of(Eigen::Vector4d::Zero(), 4.0 * Eigen::Matrix4d::Identity());
  update(track, {10.0, 0.0}, 12.0 * Eigen::Matrix2d::Identity());
  EXPECT_NEAR(track.state(0), 2.5, 1e-12);          // 10 x 4 / (4 + 12)
  EXPECT_NEAR(track.covariance(0, 0), 3.0, 1e-12);  // 1 / (1/4 + 1/12)
  EXPECT_NEAR(track.covariance(2, 2), 4.0, 1e-12);  // no correlation, nothing learnt of the velocity
}

TEST(ConstantVelocityFilter, ManyExactPositionsGiveTheVelocity) {
  core::Track track = track_of({0.0, 0.0, 0.0, 0.0}, 100.0 * Eigen::Matrix4d::Identity());
  for (int k = 1; k <= 20; ++k) {
    predict(track, 0.5, {.acceleration_sigma = 0.0});
    update(track, {1.0 * k, -0.5 * k}, 0.01 * Eigen::Matrix2d::Identity());
  }
  EXPECT_NEAR(track.state(2), 2.0, 0.01);
  EXPECT_NEAR(track.state(3), -1.0, 0.01);
}

TEST(ConstantVelocityFilter, RefusesANegativeSigma) {
  EXPECT_THROW(MotionModelParams{.acceleration_sigma = -0.1}.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
