#include "tracking/smoothing/window_smoother.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tracking/association/gating.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {
namespace {

class WindowSmootherTest : public testing::Test {
 protected:
  WindowSmootherTest() {
    track_.state << 50.0, 0.0, 1.0, 0.0;
    track_.covariance = Eigen::Matrix4d::Identity();
    detection_.p_earth = {52.0, 0.0};
    detection_.range = 52.0;
    detection_.utime = 7;
    element_.position = {51.0, 0.5};
    element_.velocity = {0.8, 0.1};
    element_.covariance = 2.0 * Eigen::Matrix4d::Identity();
  }
  WindowSmoother smoother_{{}};
  core::SonarParams sonar_;
  core::Track track_;
  core::Detection detection_;
  core::MotionElement element_;
};

TEST_F(WindowSmootherTest, YoungTrajectoriesAreTheWindowEstimate) {
  smoother_.correct(track_, 5, &detection_, &element_, sonar_);
  EXPECT_EQ(track_.state, element_.state());
  EXPECT_EQ(track_.covariance, element_.covariance);
  EXPECT_EQ(track_.last_detection_utime, 7);
}

TEST_F(WindowSmootherTest, OldOnesTakeTheNewSampleAlone) {
  core::Track expected = track_;
  update(expected, detection_.p_earth, position_noise(detection_, sonar_));
  smoother_.correct(track_, 6, &detection_, &element_, sonar_);
  EXPECT_TRUE(track_.state.isApprox(expected.state));
}

TEST_F(WindowSmootherTest, DisagreementResetsToTheWindow) {
  element_.position = {50.0 + 6.1 * std::sqrt(3.0), 0.0};  // 6.1 sigma: 37.2 > 36
  element_.velocity = {1.0, 0.0};
  smoother_.correct(track_, 50, nullptr, &element_, sonar_);
  EXPECT_EQ(track_.state, element_.state());
}

TEST_F(WindowSmootherTest, JustBelowItDoesNot) {
  element_.position = {50.0 + 5.9 * std::sqrt(3.0), 0.0};  // 5.9 sigma: 34.8 < 36
  element_.velocity = {1.0, 0.0};
  smoother_.correct(track_, 50, nullptr, &element_, sonar_);
  EXPECT_EQ(track_.state(0), 50.0);
}

TEST_F(WindowSmootherTest, WithNeitherNothingChanges) {
  const core::Track before = track_;
  smoother_.correct(track_, 0, nullptr, nullptr, sonar_);
  EXPECT_EQ(track_.state, before.state);
}

TEST(WindowSmoother, RefusesParametersOutOfRange) {
  EXPECT_THROW(WindowSmoother({.disagreement = 0.0}), std::invalid_argument);
  EXPECT_THROW(WindowSmoother({.young_scans = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
