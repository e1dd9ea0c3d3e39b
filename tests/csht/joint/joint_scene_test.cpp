#include "csht/joint/joint_scene.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

JointScene two_slots() {
  JointEngineParams params;
  params.hypotheses.max_tracks = 2;
  JointScene scene(params, {}, {});
  scene.take(scan_of(0, {{60.0, 0.5}}));
  return scene;
}

TEST(JointScene, FillsSlotsUpToTheLimitAndCountsIdentities) {
  JointScene scene = two_slots();
  scene.set_next_id(11);
  for (int k = 0; k < 2; ++k) {
    TargetTrack* track = scene.free_track();
    ASSERT_NE(track, nullptr);
    EXPECT_EQ(track->id, 11 + k);
    EXPECT_EQ(scene.slot_of(*track), k);
    track->used = true;
  }
  EXPECT_EQ(scene.free_track(), nullptr);
  EXPECT_EQ(scene.next_id(), 13);
}

TEST(JointScene, AReleasedHypothesisGivesItsSlotAndItsClaimsBack) {
  JointScene scene = two_slots();
  TargetTrack& track = *scene.free_track();
  track.used = true;
  scene.likelihood.set_existence(0, 1.0);
  scene.likelihood.add_claim(0, {0, 45, 60.0F, 1.0F});
  EXPECT_GT(scene.likelihood.explained(0, 45, 60.0), 0.9);
  scene.release(track);
  EXPECT_EQ(scene.likelihood.explained(0, 45, 60.0), 0.0);
  EXPECT_EQ(scene.free_track(), &track);
  EXPECT_EQ(track.id, 2);  // A new identity.
}

// Sonar 1 alarms in nine beams of ten, sonar 2 in none.
TEST(JointScene, EachSonarHasFiguresOfItsOwn) {
  JointScene scene({}, {}, {});
  for (int k = 0; k < 40; ++k) {
    core::PosedScan loud = scan_of(k, {}), quiet = scan_of(k, {});
    loud.scan.sensor_id = 1;
    quiet.scan.sensor_id = 2;
    for (int beam = 0; beam < 90; ++beam)
      if ((beam + k) % 10 != 0)
        loud.scan.returns.push_back({core::radians(-44.5 + beam), 20.0 + (beam * 37 + k * 53) % 120});
    scene.take(loud);
    scene.learn();
    EXPECT_EQ(scene.scans().newest().sensor, 0);
    scene.take(quiet);
    scene.learn();
    EXPECT_EQ(scene.scans().newest().sensor, 1);
  }
  EXPECT_LT(scene.learning().figures().false_alarm_probability, 0.02);  // The newest scan's: sonar 2.
  scene.take(scan_of(40, {}));                                          // A third.
  core::PosedScan loud = scan_of(41, {});
  loud.scan.sensor_id = 1;
  scene.take(loud);
  EXPECT_GT(scene.learning().figures().false_alarm_probability, 0.7);
  EXPECT_GT(scene.scans().figures().false_alarm_probability, 0.7);
}

TEST(JointScene, TellsTheSecondsBetweenScans) {
  JointScene scene = two_slots();
  EXPECT_DOUBLE_EQ(scene.take(scan_of(3, {})), 1.5);  // Scans come every half second.
}

}  // namespace
}  // namespace lookout::csht
