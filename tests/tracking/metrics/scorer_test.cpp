#include "tracking/metrics/scorer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lookout::tracking {
namespace {

core::Track track(std::int64_t id, core::TrackStatus status, double north) {
  core::Track result;
  result.id = id;
  result.status = status;
  result.state = {north, 0.0, 1.0, 0.0};
  return result;
}

core::TargetTruth target(std::int32_t id, double north, bool visible) {
  return {id, {north, 0.0}, {1.0, 0.0}, visible};
}

// One target in view, followed; one out of view, kept as a coasting track 3 m off; a tentative track at both.
const core::GroundTruth kTruth{0, {target(1, 50.0, true), target(2, 200.0, false)}};
const std::vector<core::Track> kTracks{track(1, core::TrackStatus::confirmed, 50.0),
                                       track(2, core::TrackStatus::coasting, 203.0),
                                       track(3, core::TrackStatus::tentative, 90.0)};

TEST(Scorer, VisibleLeavesOutTargetsOutOfViewAndCoastingTracks) {
  Scorer scorer({}, TruthKind::visible);
  EXPECT_EQ(scorer.add(kTruth, kTracks).position.total, 0.0);
  EXPECT_EQ(scorer.mean().position.num_truth, 1);
}

TEST(Scorer, ScheduleCountsBoth) {
  Scorer scorer({}, TruthKind::schedule);
  EXPECT_NEAR(scorer.add(kTruth, kTracks).position.total, 3.0 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(scorer.mean().position.num_tracks, 2);
}

TEST(Scorer, MeanIsOverScans) {
  Scorer scorer;
  scorer.add(kTruth, kTracks);
  scorer.add(kTruth, {});
  EXPECT_EQ(scorer.num_scans(), 2);
  EXPECT_DOUBLE_EQ(scorer.mean().position.total, 10.0);
  EXPECT_DOUBLE_EQ(scorer.mean().velocity.cardinality, 10.0);
  EXPECT_EQ(Scorer().mean().position.total, 0.0);
}

TEST(Scorer, TruthKindByName) {
  EXPECT_EQ(truth_kind("visible"), TruthKind::visible);
  EXPECT_EQ(truth_kind("schedule"), TruthKind::schedule);
  EXPECT_FALSE(truth_kind("all"));
}

}  // namespace
}  // namespace lookout::tracking
