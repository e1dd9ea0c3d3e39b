#include "tools/experiments/track_before_detect/sonar_score.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

core::Track track_at(double north, double east, core::TrackStatus status) {
  core::Track track;
  track.status = status;
  track.state << north, east, 1.0, 0.0;
  track.covariance = Eigen::Vector4d(4.0, 4.0, 1.0, 1.0).asDiagonal();
  return track;
}

core::GroundTruth one_target() {
  core::GroundTruth truth;
  truth.utime = 2'000'000;
  core::TargetTruth target;
  target.id = 3;
  target.position = {10.0, 0.0};
  target.velocity = {0.0, 0.0};
  target.visible = true;
  truth.targets.push_back(target);
  return truth;
}

// Error (0, 2) m of variance 4 each: 4 / 4 over two dimensions; velocity (1, 0) of variance 1 each beside it.
TEST(SonarScore, OneTargetOneTrackAndOneFalseOne) {
  SonarScore score;
  const std::vector<core::Track> tracks{track_at(10.0, 2.0, core::TrackStatus::confirmed),
                                        track_at(90.0, 0.0, core::TrackStatus::confirmed),
                                        track_at(10.0, 0.0, core::TrackStatus::tentative)};
  score.add(one_target(), tracks);
  const Metrics metrics = score.metrics();
  EXPECT_DOUBLE_EQ(metrics.at("in_track").value, 1.0);
  EXPECT_DOUBLE_EQ(metrics.at("rmse").value, 2.0);
  EXPECT_DOUBLE_EQ(metrics.at("nees").value, 0.5);
  EXPECT_DOUBLE_EQ(metrics.at("nees_state").value, 0.5);
  EXPECT_DOUBLE_EQ(metrics.at("false_per_scan").value, 1.0);
  EXPECT_DOUBLE_EQ(metrics.at("time_to_confirm_s").value, 2.0);
}

TEST(SonarScore, ATrackFiveMetresOffHoldsNoTarget) {
  SonarScore score;
  const std::vector<core::Track> tracks{track_at(10.0, 5.1, core::TrackStatus::confirmed)};
  score.add(one_target(), tracks);
  EXPECT_DOUBLE_EQ(score.metrics().at("in_track").value, 0.0);
  EXPECT_DOUBLE_EQ(score.metrics().at("false_per_scan").value, 1.0);
  EXPECT_EQ(score.metrics().count("rmse"), 0u);
}

// As the scene is written: pulse_sigma .55 m is 1.295 m at half amplitude.
TEST(SonarScore, TheSceneHasTheLevelAndTheInstrumentThatAreSaid) {
  const sonar_sim::Scene scene = sonar_scene({{"snr_db", 6.0}, {"situation", "empty"}});
  EXPECT_EQ(scene.platforms.front().image->snr_db, 6.0);
  EXPECT_TRUE(scene.targets.empty());
  EXPECT_NEAR(sonar_instrument(true).pulse_length, 2.3548 * scene.platforms.front().image->pulse_sigma, 1e-3);
  EXPECT_EQ(sonar_instrument(false).pulse_length, 0.0);
}

}  // namespace
}  // namespace lookout::tools
