#include "tracking/association/gating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tracking {
namespace {

TEST(Gating, TwoDimensionalQuantileHasAClosedForm) {
  EXPECT_NEAR(chi_square_gate(0.95, 2), -2.0 * std::log(0.05), 1e-9);
}

TEST(Gating, OneDimensionalQuantileIsTheTabulatedOne) {
  EXPECT_NEAR(chi_square_gate(0.95, 1), 3.841, 5e-4);  // any chi-square table
}

TEST(Gating, RefusesWhatIsNoProbability) {
  EXPECT_THROW(chi_square_gate(1.0, 2), std::invalid_argument);
  EXPECT_THROW(chi_square_gate(0.9, 0), std::invalid_argument);
}

core::Detection at(double azimuth, double range) {
  core::Detection detection;
  detection.azimuth = azimuth;
  detection.range = range;
  return detection;
}

TEST(Gating, NoiseLiesAlongTheLineOfSight) {
  core::SonarParams sonar;
  sonar.range_sigma = 3.0;
  sonar.bearing_sigma = 0.01;
  const Eigen::Matrix2d noise = position_noise(at(0.5 * M_PI, 100.0), sonar);  // due east
  EXPECT_NEAR(noise(1, 1), 9.0, 1e-9);                                         // range sigma squared
  EXPECT_NEAR(noise(0, 0), 1.0, 1e-9);                                         // (100 x 0.01)^2
  EXPECT_NEAR(noise(0, 1), 0.0, 1e-9);
}

TEST(Gating, NoiseTurnsWithTheAzimuth) {
  core::SonarParams sonar;
  const Eigen::Matrix2d north = position_noise(at(0.0, 80.0), sonar);
  const double turn = 0.7;
  Eigen::Matrix2d rotation;
  rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
  const Eigen::Matrix2d expected = rotation * north * rotation.transpose();
  EXPECT_TRUE(position_noise(at(turn, 80.0), sonar).isApprox(expected, 1e-12));
}

TEST(Gating, SquaredDistanceCountsSigmas) {
  const Eigen::Matrix2d covariance = Eigen::Vector2d(4.0, 9.0).asDiagonal();
  EXPECT_NEAR(squared_distance({2.0, 3.0}, covariance), 2.0, 1e-12);  // one sigma on each axis
}

}  // namespace
}  // namespace lookout::tracking
