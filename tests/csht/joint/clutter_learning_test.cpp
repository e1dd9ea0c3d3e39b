#include "csht/joint/clutter_learning.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "csht/joint/joint_scene.hpp"
#include "tests/csht/posed_scans.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

constexpr int kScans = 60;

// A rock 80 m ahead of a sonar that stands, heard at each scan.
void show_rock(JointScene& scene, int from, int to) {
  core::Random random(4);
  for (int k = from; k < to; ++k) {
    scene.take(scan_of(k, {{80.0 + random.gaussian(1.0), 0.5}}));
    scene.learn();
  }
}

float background_of_newest(const JointScene& scene) {
  return scene.scans().newest().background[46];  // Beam 45.
}

TEST(ClutterLearning, WhatReturnsFromOnePlaceLosesItsWorth) {
  JointScene scene({}, core::SonarParams(), {});
  show_rock(scene, 0, 2);
  EXPECT_FLOAT_EQ(background_of_newest(scene), 1.0F);
  show_rock(scene, 2, kScans);
  EXPECT_LT(background_of_newest(scene), 0.1F);
}

// Scans that were priced before anything was known are judged anew.
TEST(ClutterLearning, ThePastIsJudgedAnew) {
  JointScene scene({}, core::SonarParams(), {});
  show_rock(scene, 0, kScans);
  EXPECT_LT(scene.scans().at_age(kScans - 3).background[46], 0.1F);
}

TEST(ClutterLearning, SwitchedOffItChangesNothing) {
  JointEngineParams params;
  params.clutter.map.enabled = false;
  JointScene scene(params, core::SonarParams(), {});
  show_rock(scene, 0, kScans);
  EXPECT_EQ(background_of_newest(scene), 1.0F);
}

// A return in every beam where P_F = .1 before: the scan's returns are worth a tenth, those before in full.
TEST(ClutterLearning, InABurstReturnsAreWorthLess) {
  JointScene scene({}, core::SonarParams(), {});
  core::Random random(4);
  const auto sea = [&](int k, double probability) {
    std::vector<core::SonarReturn> returns;
    for (int beam = 0; beam < 90; ++beam)
      if (random.bernoulli(probability))
        returns.push_back({core::radians(-44.5 + beam), random.uniform(1.0, 149.0), 1});
    scene.take(posed_scan(returns, 500'000L * k));
    scene.learn();
  };
  for (int k = 0; k < 20; ++k) sea(k, 0.1);
  sea(20, 1.0);
  EXPECT_NEAR(scene.scans().newest().usual, 0.1F, 0.03F);
  EXPECT_EQ(scene.scans().at_age(1).usual, 1.0F);
}

// A hypothesis on the rock had the worth of its returns; when they lose it, so does the hypothesis.
TEST(ClutterLearning, HypothesesFollowWhatIsJudgedAnew) {
  JointScene scene({}, core::SonarParams(), {});
  show_rock(scene, 0, 3);
  TargetTrack* track = scene.free_track();
  ASSERT_NE(track, nullptr);
  track->used = true;
  track->cloud.resize(2);
  track->cloud.north = {80.0, 80.5};
  track->cloud.east = {0.5, 0.5};
  track->cloud.weight = {0.5, 0.5};
  track->log_odds = 10.0;
  track->first_scan = 0;
  show_rock(scene, 3, kScans);
  EXPECT_LT(scene.tracks[0].log_odds, 0.0);
}

}  // namespace
}  // namespace lookout::csht
