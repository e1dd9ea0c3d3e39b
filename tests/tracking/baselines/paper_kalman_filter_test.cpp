#include "tracking/baselines/paper_kalman_filter.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {
namespace {

core::Track first_track(const PaperKalmanFilter& filter) {
  core::Track track;
  track.state << 10.0, 20.0, 1.0, -1.0;
  track.covariance = filter.initial_covariance();
  return track;
}

std::optional<Eigen::Vector2d> nothing(const Eigen::Vector2d& /*predicted*/, const Eigen::Matrix2d& /*s*/) {
  return std::nullopt;
}

TEST(PaperKalmanFilter, BeginsWithThePapersCovariance) {
  EXPECT_TRUE(PaperKalmanFilter({}).initial_covariance().diagonal().isApprox(
      Eigen::Vector4d(25.0, 25.0, 4.0, 4.0)));  // [Yan2018] P0
}

TEST(PaperKalmanFilter, OwnFilterIsTheOracleOfTheEngine) {
  PaperKalmanFilter engine({});
  core::Track by_engine = first_track(engine);
  core::Track by_us = by_engine;
  for (int k = 1; k <= 5; ++k) {
    const Eigen::Vector2d measured(10.0 + k, 20.0 - 2.0 * k);
    EXPECT_TRUE(engine.iterate(by_engine, 0.5, [&](const auto&, const auto&) { return measured; }));
    predict(by_us, 0.5, {.acceleration_sigma = 4.9});
    update(by_us, measured, 9.0 * Eigen::Matrix2d::Identity());
  }
  EXPECT_TRUE(by_engine.state.isApprox(by_us.state, 1e-9));
  EXPECT_TRUE(by_engine.covariance.isApprox(by_us.covariance, 1e-9));
}

TEST(PaperKalmanFilter, WithoutAMeasurementItPredicts) {
  PaperKalmanFilter filter({});
  core::Track track = first_track(filter);
  EXPECT_FALSE(filter.iterate(track, 2.0, nothing));
  EXPECT_TRUE(track.state.isApprox(Eigen::Vector4d(12.0, 18.0, 1.0, -1.0)));
}

TEST(PaperKalmanFilter, ChoosesFromPredictionAndInnovation) {
  PaperKalmanFilter filter({.process_sigma = 1e-6});
  core::Track track = first_track(filter);
  filter.iterate(track, 0.5, [](const Eigen::Vector2d& predicted, const Eigen::Matrix2d& innovation) {
    EXPECT_TRUE(predicted.isApprox(Eigen::Vector2d(10.5, 19.5)));
    EXPECT_NEAR(innovation(0, 0), 35.0, 1e-6);  // 25 + .25 x 4 + 9
    return std::optional<Eigen::Vector2d>();
  });
}

TEST(PaperKalmanFilter, RefusesParametersOutOfRange) {
  EXPECT_THROW(PaperKalmanFilter({.process_sigma = 0.0}), std::invalid_argument);
  EXPECT_THROW(PaperKalmanFilter({.position_sigma = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
