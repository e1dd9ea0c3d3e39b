#include "tracking/joint_observer.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

// Half the cloud on an echo dead ahead at 60 m, half on a silent place 20 m to starboard.
JointTrack split_track() {
  JointTrack track;
  track.cloud.resize(2);
  track.cloud.north = {60.0, 60.0};
  track.cloud.east = {0.5, 20.0};
  track.cloud.weight = {0.5, 0.5};
  return track;
}

TEST(JointObserver, SeesVisibilityAndEcho) {
  JointLikelihood likelihood({}, {}, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}}));
  JointTrack track = split_track();
  JointObserver().observe(0, track, false, likelihood);
  EXPECT_DOUBLE_EQ(track.visible_share, 1.0);
  EXPECT_DOUBLE_EQ(track.echo_share, 0.5);
  track.cloud.east[1] = 200.0;
  JointObserver().observe(0, track, false, likelihood);
  EXPECT_DOUBLE_EQ(track.visible_share, 0.5);
}

TEST(JointObserver, ClaimsEachBeamByItsShare) {
  JointLikelihood likelihood({}, {}, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}}));
  likelihood.set_existence(0, 1.0);
  JointTrack track = split_track();
  JointObserver().observe(0, track, true, likelihood);
  EXPECT_NEAR(likelihood.explained(0, 45, 60.0), 0.5, 1e-6);
  EXPECT_NEAR(likelihood.explained(0, 63, 63.2), 0.5, 1e-6);  // 18.4 deg.
}

TEST(JointObserver, APointSensorsEchoIsClaimedByItsLikelihood) {
  csht::SensorModelParams model;
  model.clutter = csht::ClutterModel::point;
  JointLikelihood likelihood({}, model, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}, {60.0, 40.0}}));
  likelihood.set_existence(0, 1.0);
  JointTrack track = split_track();
  track.cloud.east[1] = 0.5;
  JointObserver().observe(0, track, true, likelihood);
  EXPECT_GT(likelihood.explained(0, 0, 60.0), 0.9);
  EXPECT_LT(likelihood.explained(0, 1, 72.1), 0.01);
}

}  // namespace
}  // namespace lookout::tracking
