#include "tracking/baselines/gaussian/gaussian_target.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {
namespace {

GaussianTarget target_at(double north, double east) {
  GaussianTarget target;
  target.modes[0].mean << north, east, 1.0, -0.5;
  target.modes[0].covariance = Eigen::Vector4d(4.0, 9.0, 0.3, 0.2).asDiagonal();
  target.modes[0].covariance(0, 2) = target.modes[0].covariance(2, 0) = 0.5;
  return target;
}

TEST(GaussianTarget, OneModeIsTheKalmanFilter) {
  const GaussianTarget target = target_at(50.0, 10.0);
  core::Track track;
  track.state = target.mean();
  track.covariance = target.covariance();
  Eigen::Matrix2d noise;
  noise << 5.0, 1.0, 1.0, 3.0;
  update(track, {52.0, 9.0}, noise);
  const GaussianTarget result = updated(target, {{52.0, 9.0}, noise});
  EXPECT_LT((result.mean() - track.state).norm(), 1e-12);
  EXPECT_LT((result.covariance() - track.covariance).norm(), 1e-12);
}

TEST(GaussianTarget, DensityIsTheNormalOneOfTheInnovation) {
  // Covariance diag(4 + 5, 9 + 16), 3 and 5 from the mean: exp(-1) / (2 pi 3 5).
  const Eigen::Matrix2d noise = Eigen::Vector2d(5.0, 16.0).asDiagonal();
  const PositionMeasurement measurement{{53.0, 15.0}, noise};
  EXPECT_NEAR(density(target_at(50.0, 10.0), measurement), std::exp(-1.0) / (2.0 * std::numbers::pi * 15.0),
              1e-12);
  EXPECT_NEAR(squared_distance(target_at(50.0, 10.0), measurement), 2.0, 1e-12);
}

TEST(GaussianTarget, ModesAreReweighedByTheirDensities) {
  GaussianTarget target = target_at(50.0, 10.0);
  target.num_modes = 2;
  target.modes[1] = target.modes[0];
  target.modes[1].mean.head<2>() << 56.0, 10.0;
  target.modes[0].weight = target.modes[1].weight = 0.5;
  const Eigen::Matrix2d noise = Eigen::Vector2d(5.0, 16.0).asDiagonal();
  const GaussianTarget result = updated(target, {{50.0, 10.0}, noise});
  // 0 against 6 m off at a variance of 9 m^2: odds exp(2).
  EXPECT_NEAR(result.modes[0].weight / result.modes[1].weight, std::exp(2.0), 1e-9);
  EXPECT_NEAR(result.modes[0].weight + result.modes[1].weight, 1.0, 1e-12);
}

TEST(GaussianTarget, TheSpreadOfModesCounts) {
  GaussianTarget target = target_at(50.0, 10.0);
  target.num_modes = 2;
  target.modes[1] = target.modes[0];
  target.modes[1].mean(0) = 54.0;
  target.modes[0].weight = target.modes[1].weight = 0.5;
  EXPECT_DOUBLE_EQ(target.mean()(0), 52.0);
  EXPECT_DOUBLE_EQ(target.covariance()(0, 0), 4.0 + 4.0);  // within, and 2 m either way
}

}  // namespace
}  // namespace lookout::tracking
