#include "tracking/initiation/methods/sequence_ht.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(SequenceHt, DeclaresSixTracksWhateverIsThere) {
  core::Random random(1025);
  test::SceneOptions options;
  options.scans = 4;
  options.clutter = 60;
  options.half_width = 50e3;
  const auto method = make_sequence_ht({});
  EXPECT_EQ(method->start(test::scene_of({}, options, random)).tracks.size(), 6u);  // [Zeng2023] Table 2.
}

TEST(SequenceHt, TakesTheHighestCellFirstAndItsPlotsAway) {
  // Two parallel targets 5 km apart in four scans; rows of 750 m.
  core::Random random(1026);
  test::SceneOptions options;
  options.scans = 4;
  const auto method = make_sequence_ht({});
  const StartedTracks& started =
      method->start(test::scene_of({{{0, 1000}, {250, 0}}, {{0, 6000}, {250, 0}}}, options, random));
  ASSERT_GE(started.tracks.size(), 2u);
  EXPECT_GE(started.tracks[0].score, 4.0);  // A target's plots lie in one cell; others may join them there.
  EXPECT_GE(started.tracks[0].score, started.tracks[1].score);
  std::vector<int> plots = started.plots;
  std::sort(plots.begin(), plots.end());
  EXPECT_EQ(std::adjacent_find(plots.begin(), plots.end()), plots.end());  // No plot twice.
}

TEST(SequenceHt, RefusesParametersOutOfRange) {
  SequenceHtParams params;
  params.min_plots = 1;
  EXPECT_THROW(SequenceHtInitiator{params}, std::invalid_argument);
  params = {};
  params.window_scans = 1;
  EXPECT_THROW(SequenceHtInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
