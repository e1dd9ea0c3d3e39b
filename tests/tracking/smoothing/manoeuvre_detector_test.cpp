#include "tracking/smoothing/manoeuvre_detector.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

const Eigen::Matrix2d kNoise = 3.0 * Eigen::Matrix2d::Identity();

/// A track with position variance 1: with the noise of 3 an innovation has the deviation 2 m.
core::Track track_at_origin() {
  core::Track track;
  track.covariance = Eigen::Matrix4d::Identity();
  return track;
}

TEST(ManoeuvreDetector, TheMeanIsOfWhitenedInnovations) {
  core::Track track = track_at_origin();
  Eigen::Vector2d drift(1.0, 0.0);
  EXPECT_FALSE(ManoeuvreDetector({}).notice(track, drift, {0.0, 4.0}, kNoise));
  EXPECT_TRUE(drift.isApprox(Eigen::Vector2d(0.8, 0.4)));  // .8 x 1, .2 x 4 / 2
  EXPECT_EQ(track.covariance, Eigen::Matrix4d::Identity());
}

TEST(ManoeuvreDetector, ScatterOfTwoDeviationsIsNoManoeuvre) {
  core::Track track = track_at_origin();
  Eigen::Vector2d drift(0.0, 0.0);
  for (int k = 0; k < 50; ++k)
    EXPECT_FALSE(ManoeuvreDetector({}).notice(track, drift, {k % 2 ? 4.0 : -4.0, 0.0}, kNoise));
}

// Detections that stay two deviations ahead: the mean is 2 (1 - .8^k), its square times 9 passes 20 where
// .8^k < 1 - sqrt(20 / 36), with the seventh detection.
TEST(ManoeuvreDetector, AConstantOffsetOpensTheCovariance) {
  core::Track track = track_at_origin();
  Eigen::Vector2d drift(0.0, 0.0);
  int detections = 1;
  while (!ManoeuvreDetector({}).notice(track, drift, {4.0, 0.0}, kNoise) && detections < 20) ++detections;
  EXPECT_EQ(detections, 7);
  EXPECT_TRUE(track.covariance.diagonal().isApprox(Eigen::Vector4d(4.0, 4.0, 1.3, 1.3)));
  EXPECT_EQ(drift, Eigen::Vector2d(0.0, 0.0));
}

TEST(ManoeuvreDetector, RefusesParametersOutOfRange) {
  EXPECT_THROW(ManoeuvreDetector({.share = 1.0}), std::invalid_argument);
  EXPECT_THROW(ManoeuvreDetector({.threshold = 0.0}), std::invalid_argument);
  EXPECT_THROW(ManoeuvreDetector({.velocity_variance = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
