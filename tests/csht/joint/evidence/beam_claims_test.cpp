#include "csht/joint/evidence/beam_claims.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

// Half the cloud on a detection dead ahead at 60 m, half on a silent place 20 m to starboard.
TargetTrack split_track() {
  TargetTrack track;
  track.cloud.resize(2);
  track.cloud.north = {60.0, 60.0};
  track.cloud.east = {0.5, 20.0};
  track.cloud.weight = {0.5, 0.5};
  return track;
}

TEST(BeamClaims, SeesVisibilityAndDetection) {
  ScanLikelihood likelihood({}, {}, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}}));
  TargetTrack track = split_track();
  BeamClaims().observe(0, track, false, likelihood);
  EXPECT_DOUBLE_EQ(track.visible_share, 1.0);
  EXPECT_DOUBLE_EQ(track.detected_share, 0.5);
  track.cloud.east[1] = 200.0;
  BeamClaims().observe(0, track, false, likelihood);
  EXPECT_DOUBLE_EQ(track.visible_share, 0.5);
}

TEST(BeamClaims, ClaimsEachBeamByItsShare) {
  ScanLikelihood likelihood({}, {}, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}}));
  likelihood.set_existence(0, 1.0);
  TargetTrack track = split_track();
  BeamClaims().observe(0, track, true, likelihood);
  EXPECT_NEAR(likelihood.explained(0, 45, 60.0), 0.5, 1e-6);
  EXPECT_NEAR(likelihood.explained(0, 63, 63.2), 0.5, 1e-6);  // 18.4 deg.
}

TEST(BeamClaims, APointSensorsDetectionIsClaimedByItsLikelihood) {
  SensorModelParams model;
  model.clutter = ClutterModel::point;
  ScanLikelihood likelihood({}, model, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.5}, {60.0, 40.0}}));
  likelihood.set_existence(0, 1.0);
  TargetTrack track = split_track();
  track.cloud.east[1] = 0.5;
  BeamClaims().observe(0, track, true, likelihood);
  EXPECT_GT(likelihood.explained(0, 0, 60.0), 0.9);
  EXPECT_LT(likelihood.explained(0, 1, 72.1), 0.01);
}

}  // namespace
}  // namespace lookout::csht
