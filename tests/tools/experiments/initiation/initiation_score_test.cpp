#include "tools/experiments/initiation/initiation_score.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/initiation/initiation_run.hpp"

namespace lookout::tools {
namespace {

/// Two targets of four plots each (sources 0-3, 4-7) and four plots of clutter.
InitiationScene small_scene() {
  InitiationScene scene;
  scene.num_targets = 2;
  scene.target_of = {0, 0, 0, 0, 1, 1, 1, 1, -1, -1, -1, -1};
  return scene;
}

TEST(InitiationScore, CountsFoundFalseAndDuplicates) {
  const std::vector<TrackSources> tracks{{0, 1, 2, 8}, {1, 2, 3}, {4, 5, 9, 10}, {8, 9, 10, 11}};
  const TrackScore strict = score_tracks(small_scene(), tracks, 4, TrueTrack::strict);
  EXPECT_EQ(strict.declared, 4);
  EXPECT_EQ(strict.targets_found, 1);  // the first: three of four scans
  EXPECT_EQ(strict.duplicates, 1);     // the second
  EXPECT_EQ(strict.false_tracks, 2);
  const std::vector<TrackSources> half{{4, 5, 6, 9, 10}};
  EXPECT_EQ(score_tracks(small_scene(), half, 4, TrueTrack::lenient).targets_found, 1);  // 3 of 5
  EXPECT_EQ(score_tracks(small_scene(), half, 4, TrueTrack::share).targets_found, 0);    // below 75 %
}

TEST(InitiationScore, SurvivorsAreTargetPlotsAlone) {
  EXPECT_DOUBLE_EQ(surviving_share(small_scene(), {0, 0, 4, 9, 11}), 2.0 / 8.0);
}

/// [Fan2018] Situation I, MHT-TI: the peaks are 6 high, the strongest other cell 1, so D = 6;
/// docs/initiators.md 7 A.
TEST(InitiationScore, AccumulatorOfSituationOne) {
  core::Random random(1011);
  FanSceneParams params;
  params.situation = "I";
  const InitiationScene scene = fan_scene(params, random);
  const InitiationRun run = run_initiator(scene, "mht_ti", {});
  AccumulatorScoreParams score_params;
  const AccumulatorScore score =
      score_accumulator(scene, dynamic_cast<const tracking::HoughInitiator&>(*run.method), score_params);
  EXPECT_DOUBLE_EQ(score.discrimination, 6.0);
  EXPECT_DOUBLE_EQ(score.divergence, 0.0);
  EXPECT_DOUBLE_EQ(score.decline, 0.0);
  EXPECT_DOUBLE_EQ(score.found, 1.0);
}

TEST(InitiationScene, RealTracksAreThoseOfTheTable) {
  core::Random random(1012);
  const InitiationScene scene = real_scene(0.0, 60.0, random);
  ASSERT_EQ(scene.scans.size(), 7u);
  EXPECT_EQ(scene.scans[6][2].position, Eigen::Vector2d(-16459.0, 28155.0));
  EXPECT_DOUBLE_EQ(scene.times[1] - scene.times[0], 10.0);
}

TEST(InitiationScene, ZengTargetsAreWhereThePaperPutsThem) {
  core::Random random(1013);
  ZengSceneParams params;
  params.clutter_per_scan = 0.0;
  params.range_sigma = 1e-6;
  params.azimuth_sigma = 1e-12;
  const InitiationScene scene = zeng_scene(params, random);
  EXPECT_NEAR(scene.scans[0][4].position.x(), 55e3, 1e-3);
  EXPECT_NEAR(scene.scans[0][4].position.y(), 15e3, 1e-3);
  EXPECT_NEAR(scene.scans[1][0].position.x(), 57.5e3, 100.0);  // 500 m/s for 5 s, pushed by 12.5 m rms
}

/// What VCT must hold on the paper's own scene, on a development seed: P2 of nearly all, hardly a false
/// track.
TEST(InitiationRun, VctFindsTheTargetsOfTheRadarScene) {
  int found = 0;
  int wrong = 0;
  for (int run = 0; run < 10; ++run) {
    core::Random random(1014, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
    const InitiationScene scene = zeng_scene({}, random);
    tracking::InitiatorConfig config;
    config.min_speed = 333.0;
    config.max_speed = 750.0;
    const InitiationRun result = run_initiator(scene, "vct", config);
    const TrackScore score = score_tracks(scene, result.tracks, 4, TrueTrack::strict);
    found += score.targets_found;
    wrong += score.false_tracks;
  }
  EXPECT_GE(found, 48);  // of 50: 0.985 less two standard errors
  EXPECT_LE(wrong, 2);
}

}  // namespace
}  // namespace lookout::tools
