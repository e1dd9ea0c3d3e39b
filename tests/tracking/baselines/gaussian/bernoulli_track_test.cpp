#include "tracking/baselines/gaussian/bernoulli_track.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMany = 1000.0;  // Events of a cluster: more than there are.

core::SonarParams known_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = 0.3;
  sonar.false_alarm_probability = 0.2;
  return sonar;
}

BernoulliTrack track_at(double north, double east, double existence, const ScanView& view) {
  BernoulliTrack track;
  track.target.modes[0].mean << north, east, 0.0, 0.0;
  track.target.modes[0].covariance = Eigen::Matrix4d::Identity();
  track.existence = existence;
  track.spread = view.spread_of(track.target);
  return track;
}

TEST(BernoulliUpdate, ASilentScanIsTheMarkovChainsBayes) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {}));
  std::vector<BernoulliTrack> tracks{track_at(60.0, 0.0, 0.5, scene.view())};
  const double miss = scene.view().miss_ratio(tracks[0].spread, {tracks[0].target, 0.5});
  BernoulliUpdate(kMany).update(tracks, scene, {});
  EXPECT_NEAR(tracks[0].existence, 0.5 * miss / (0.5 + 0.5 * miss), 1e-12);
  EXPECT_EQ(tracks[0].detected, 0.0);
}

TEST(BernoulliUpdate, OneReturnOneTrackByHand) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}}));
  const auto& seen = scene.view().returns()[0];
  std::vector<BernoulliTrack> tracks{track_at(60.0, 0.0, 0.1, scene.view())};
  const double miss = scene.view().miss_ratio(tracks[0].spread, {tracks[0].target, 0.1});
  const double own = scene.view().return_ratio(tracks[0].target, seen) / (1.0 + scene.birth_ratio(seen));
  const std::vector<double> free{1.0};
  BernoulliUpdate update(kMany);
  update.update(tracks, scene, free);
  const double total = 0.9 + 0.1 * miss + 0.1 * own;
  EXPECT_NEAR(tracks[0].existence, (0.1 * miss + 0.1 * own) / total, 1e-12);
  EXPECT_NEAR(tracks[0].detected, 0.1 * own / total, 1e-12);
  EXPECT_NEAR(update.unclaimed(0), 1.0 - 0.1 * own / total, 1e-12);
}

TEST(BernoulliUpdate, AReturnThatIsTakenElsewhereDoesNotCount) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}}));
  std::vector<BernoulliTrack> tracks{track_at(60.0, 0.0, 0.1, scene.view())};
  const std::vector<double> taken{0.0};
  BernoulliUpdate(kMany).update(tracks, scene, taken);
  EXPECT_EQ(tracks[0].detected, 0.0);
  EXPECT_EQ(tracks[0].target.mean()(0), 60.0);
}

TEST(BernoulliTrack, TalliesWhatItsTracksSayOfTheSensor) {
  RivalScene scene({}, {}, known_sonar());
  scene.look(scan_of(0, {{61.0, 0.0}, {100.0, 20.0}, {90.0, -20.0}}));
  std::vector<BernoulliTrack> tracks{track_at(60.0, 0.0, 0.95, scene.view()),
                                     track_at(80.0, 40.0, 0.2, scene.view())};
  tracks[0].life.step({}, {0, 0.95, true});
  tracks[0].detected = 0.8;
  tracks[1].detected = 0.1;
  const ScanTally tally = tally_of(tracks, scene.view());
  EXPECT_NEAR(tally.false_returns, 3.0 - 0.9, 1e-12);
  EXPECT_NEAR(tally.targets, 0.95, 1e-6);  // the doubtful one teaches nothing
  EXPECT_NEAR(tally.detected, 0.8, 1e-12);
}

TEST(BernoulliTrack, IsReportedWithItsExistence) {
  BernoulliTrack track;
  track.id = 7;
  track.existence = 0.3;
  track.target.modes[0].mean << 1.0, 2.0, 3.0, 4.0;
  EXPECT_EQ(to_track(track).id, 7);
  EXPECT_EQ(to_track(track).existence, 0.3);
  EXPECT_EQ(to_track(track).state, Eigen::Vector4d(1.0, 2.0, 3.0, 4.0));
}

}  // namespace
}  // namespace lookout::tracking
