#include "tracking/joint/sensor_learning.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/tracking/joint/joint_scenes.hpp"
#include "tracking/joint/joint_tracker.hpp"

namespace lookout::tracking {
namespace {

// Weights 1/4 and 3/4: of 8 equally likely trajectories, 2 and 6.
TEST(Resample, TakesTrajectoriesByTheirWeights) {
  csht::TrajectoryCloud cloud;
  cloud.resize(2);
  cloud.north = {1.0, 2.0};
  cloud.weight = {0.25, 0.75};
  std::vector<Eigen::Vector4d> samples;
  resample(cloud, 8, samples);
  ASSERT_EQ(samples.size(), 8U);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_DOUBLE_EQ(samples[i][0], i < 2 ? 1.0 : 2.0);
}

// Echoes in 9 of 90 beams: the share is 0.1.
std::vector<Eigen::Vector2d> nine_echoes() {
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < 9; ++k) {
    const double bearing = core::radians(-40.5 + 9.0 * k);
    points.emplace_back(80.0 * std::cos(bearing), 80.0 * std::sin(bearing));
  }
  return points;
}

TEST(SensorLearning, UnknownFalseAlarmsAreLearntFromFreeBeams) {
  core::SonarParams unknown;
  TrackerState state({}, unknown, 1);
  SensorLearning learning({}, 0.5, unknown);
  for (int k = 0; k < 20; ++k) {
    state.likelihood.push(scan_of(k, nine_echoes()));
    learning.learn(state);
  }
  EXPECT_NEAR(learning.estimate().false_alarm_probability, 0.1, 0.005);
  // The likelihood uses what was learnt.
  EXPECT_NEAR(state.scans().figures().false_alarm_probability, 0.1, 0.005);
}

TEST(SensorLearning, FiguresThatFitAreLeftAsGiven) {
  TrackerState state({}, clear_sonar(), 1);
  SensorLearning learning({}, 0.5, clear_sonar());
  state.likelihood.push(scan_of(0, nine_echoes()));  // P_F = .1 is given.
  learning.learn(state);
  EXPECT_DOUBLE_EQ(learning.figures().false_alarm_probability, 0.1);
  EXPECT_DOUBLE_EQ(learning.figures().miss_probability, 0.1);
}

// Four targets appear in view in the 20th scan and never miss an echo. Were they held against the scans
// before, each would have missed ten.
TEST(SensorLearning, TargetsThatAppearInViewAreNoMissesOfTheScansBefore) {
  core::SonarParams unknown;
  JointTracker tracker({}, unknown, 1);
  for (int k = 0; k < 40; ++k)
    tracker.update(scan_of(k, k < 20
                                  ? std::vector<Eigen::Vector2d>{}
                                  : std::vector<Eigen::Vector2d>{{60, 20}, {90, -40}, {40, 0}, {110, 30}}));
  EXPECT_LT(tracker.sensor_estimate()->miss_probability, 0.2);
}

}  // namespace
}  // namespace lookout::tracking
