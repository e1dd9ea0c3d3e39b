#include "csht/joint/sensor_learning.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/random.hpp"
#include "csht/joint/joint_scene.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

// Weights 1/4 and 3/4: of 8 equally likely trajectories, 2 and 6.
TEST(Resample, TakesTrajectoriesByTheirWeights) {
  TrajectoryCloud cloud;
  cloud.resize(2);
  cloud.north = {1.0, 2.0};
  cloud.weight = {0.25, 0.75};
  std::vector<Eigen::Vector4d> samples;
  resample(cloud, 8, samples);
  ASSERT_EQ(samples.size(), 8U);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_DOUBLE_EQ(samples[i][0], i < 2 ? 1.0 : 2.0);
}

// Returns in 9 of 90 beams, the share is 0.1, at ranges and bearings that no two scans have in common.
std::vector<Eigen::Vector2d> nine_returns(int scan = 0) {
  core::Random random(static_cast<std::uint64_t>(scan) + 1);
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < 9; ++k) {
    const double range = random.uniform(5.0, 145.0);
    const double bearing = core::radians(-44.5 + 10.0 * k + random.index(10));
    points.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  return points;
}

TEST(SensorLearning, UnknownFalseAlarmsAreLearntFromFreeBeams) {
  JointScene scene({}, core::SonarParams(), {});
  for (int k = 0; k < 20; ++k) {
    scene.take(scan_of(k, nine_returns(k)));
    scene.learn();
  }
  EXPECT_NEAR(scene.learning().estimate().false_alarm_probability, 0.1, 0.005);
  // The likelihood uses what was learnt.
  EXPECT_NEAR(scene.scans().figures().false_alarm_probability, 0.1, 0.005);
}

TEST(SensorLearning, FiguresThatFitAreLeftAsGiven) {
  core::SonarParams sonar;
  sonar.miss_probability = sonar.false_alarm_probability = 0.1;
  JointScene scene({}, sonar, {});
  scene.take(scan_of(0, nine_returns()));
  scene.learn();
  EXPECT_DOUBLE_EQ(scene.learning().figures().false_alarm_probability, 0.1);
  EXPECT_DOUBLE_EQ(scene.learning().figures().miss_probability, 0.1);
}

// A sure track on a thing 60 m ahead that every scan hears, at this velocity north.
double miss_probability_beside(double speed) {
  JointScene scene({}, core::SonarParams(), {});
  TargetTrack track;
  track.cloud.resize(1);
  track.cloud.weight = {1.0};
  TargetTrack::Beginning beginning;
  beginning.log_odds = 10.0;
  for (int k = 0; k < 40; ++k) {
    const double north = 60.0 + 0.5 * k * speed;
    scene.take(scan_of(k, {{north, 0.0}}));
    track.cloud.north = {north};
    track.cloud.north_velocity = {speed};
    track.moments = track.cloud.moments();
    if (k == 0) track.begin(beginning);
    track.recent.add(1.0, 1.0);
    scene.tracks.assign(1, track);
    scene.learn();
  }
  return scene.learning().estimate().miss_probability;
}

TEST(SensorLearning, WhatStandsTeachesNoMisses) {
  EXPECT_DOUBLE_EQ(miss_probability_beside(0.0), 0.5);  // As before anything is learnt.
  EXPECT_LT(miss_probability_beside(1.0), 0.1);         // 30 scans and four trials of one half: .06.
}

}  // namespace
}  // namespace lookout::csht
