#include "csht/joint/target_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

core::SonarParams clear_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = 0.1;
  sonar.false_alarm_probability = 0.1;
  return sonar;
}

// `count` scans of a target that moves north at 1 m/s from (60, 10) on.
JointScene scene_with_target(int count) {
  JointScene scene({}, clear_sonar(), {});
  for (int k = 0; k < count; ++k) scene.take(scan_of(k, {{60.0 + 0.5 * k, 10.0}}));
  return scene;
}

const TargetTrack& surest(const JointScene& scene) {
  return *std::max_element(scene.tracks.begin(), scene.tracks.end(), [](const auto& a, const auto& b) {
    return (a.used ? a.log_odds : -1e9) < (b.used ? b.log_odds : -1e9);
  });
}

TEST(TargetSearch, EightDetectionsOfOneTargetAreOneSureHypothesis) {
  JointScene scene = scene_with_target(8);
  TargetSearch search({});
  ASSERT_FALSE(search.find(scene).empty());
  EXPECT_NEAR(surest(scene).moments.mean[0], 63.5, 1.5);
  EXPECT_GT(surest(scene).existence(), 0.9);
}

TEST(TargetSearch, BeginsNothingOnAKnownTarget) {
  JointScene scene = scene_with_target(8);
  TargetSearch search({});
  const std::size_t first = search.find(scene).size();
  EXPECT_LE(search.find(scene).size(), first - 1);
}

TEST(TargetSearch, OneDetectionIsNoHypothesis) {
  JointScene scene = scene_with_target(1);
  EXPECT_TRUE(TargetSearch({}).find(scene).empty());
}

// What eight detections said is taken back by twelve silent scans.
TEST(TargetSearch, RevisesAHypothesisByTheScansThatCameSince) {
  JointScene scene = scene_with_target(8);
  TargetSearch search({});
  search.find(scene);
  TargetTrack& track = scene.tracks[static_cast<std::size_t>(scene.slot_of(surest(scene)))];
  for (int k = 8; k < 20; ++k) track.advance(scene.take(scan_of(k, {})));
  const double before = track.log_odds;
  search.revise(track, scene);
  EXPECT_LT(track.log_odds, before - 5.0);
}

TEST(SeedOf, TakesStateSpreadAndAgeOfTheElement) {
  ScanHistory scans({}, {}, 30);
  for (int k = 0; k < 20; ++k) scans.push(scan_of(k, {}));
  core::MotionElement element;
  element.position = {60.0, 10.0};
  element.velocity = {1.0, -0.5};
  element.covariance = 4.0 * Eigen::Matrix4d::Identity();
  element.initial_utime = 7'000'000;  // Scan 14 of 0 .. 19.
  const BirthSeed seed = seed_of(element, scans);
  EXPECT_EQ(seed.guess.mean.head<4>(), Eigen::Vector4d(60.0, 10.0, 1.0, -0.5));
  EXPECT_DOUBLE_EQ(seed.guess.covariance(2, 2), 4.0);
  EXPECT_EQ(seed.start_age, 5);
}

}  // namespace
}  // namespace lookout::csht
