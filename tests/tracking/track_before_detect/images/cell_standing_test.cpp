#include "tracking/track_before_detect/images/cell_standing.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

const PixelGeometry kGeometry(120, 80);

ScaleSpace seen() {
  core::Random random(1000);
  ScaleSpaceParams params;
  params.same_on_both_axes = true;
  params.largest = {1.5, 1.5};
  ScaleSpace scales(params, 1.9);
  scales.apply(blobs({}, 0.0, random), {1.0, 1.0}, {});
  return scales;
}

/// Followed for ten frames from (40, 40), its velocity known within a tenth.
CellTrack track_that_went(const Eigen::Vector2d& way) {
  CellTrack track;
  track.age = 10;
  track.first_position = track.first_cell = {40.0, 40.0};
  track.state << track.first_position + way, way / track.age;
  track.covariance = Eigen::Vector4d(0.1, 0.1, 0.01, 0.01).asDiagonal();
  return track;
}

CellTrack judged(const Eigen::Vector2d& way, const CellGeometry& geometry = kGeometry) {
  const CellStanding standing({});
  CellTrack track = track_that_went(way);
  standing.judge_motion(seen(), geometry, 10.0, track);
  return track;
}

/// Pixels of a camera that has gone (12, 0) since the track began.
class Gone : public CellGeometry {
 public:
  CellView observe(const Eigen::Vector2d& position) const override {
    return kGeometry.observe(position - kWay);
  }
  Eigen::Vector2d position_of(const Eigen::Vector2d& cell) const override { return cell + kWay; }
  Eigen::Vector2d cell_size() const override { return {1.0, 1.0}; }

 private:
  const Eigen::Vector2d kWay{12.0, 0.0};
};

double moving_of(const Eigen::Vector2d& way) {
  return judged(way).moving;
}

TEST(CellStanding, WhatHasMadeAWayMovesAndWhatHasNotStands) {
  EXPECT_GT(moving_of({15.0, 0.0}), 0.99);
  EXPECT_LT(moving_of({0.1, 0.0}), 0.3);
}

TEST(CellStanding, WhatGoesAlongWithTheSensorMovesOverGroundAndStandsInItsFrame) {
  EXPECT_LT(judged({12.0, 0.0}, Gone{}).moving_in_frame, 0.3);
  EXPECT_GT(judged({12.0, 0.0}, Gone{}).moving, 0.99);
  EXPECT_LT(judged({0.0, 0.0}, Gone{}).moving, 0.3);
  EXPECT_GT(judged({12.0, 9.0}, Gone{}).moving_in_frame, 0.99);
}

TEST(CellStanding, WhatGoesAlongMayBeAMarkUntilItHasDoneSoForLong) {
  const CellStandingParams params;
  CellStanding standing(params);
  CellTrack along = judged({12.0, 0.0}, Gone{}), apart = judged({12.0, 9.0}, Gone{});
  along.age = apart.age = 100;
  standing.begin(along.first_time + params.mark_time - 0.1);
  EXPECT_TRUE(standing.may_be_a_mark(along));
  EXPECT_FALSE(standing.may_be_a_mark(apart));
  standing.begin(along.first_time + params.mark_time);
  EXPECT_FALSE(standing.may_be_a_mark(along));
  EXPECT_FALSE(standing.stands(along));
  along.age = params.min_age - 1;  // of few pings, however long they took
  EXPECT_TRUE(standing.may_be_a_mark(along));
}

// Of a rock that comes into view the middle of the part that is seen makes a way over ground.
TEST(CellStanding, WhatTheBorderCutsIsJudgedFromWhenItIsWhole) {
  const CellStandingParams params;
  CellStanding standing(params);
  CellTrack track = track_that_went({12.0, 9.0});
  track.whole = false;
  track.age = 100;
  const double soon = track.first_time + 0.9 * params.mark_time, late = track.first_time + params.mark_time;
  standing.begin(soon);
  standing.judge_motion(seen(), kGeometry, soon, track);
  EXPECT_EQ(track.first_position, Eigen::Vector2d(track.state.head<2>()));
  EXPECT_EQ(track.whole_time, soon);
  EXPECT_TRUE(standing.may_be_a_mark(track));
  standing.begin(late);  // as a target that keeps to the border
  standing.judge_motion(seen(), kGeometry, late, track);
  EXPECT_EQ(track.whole_time, soon);
  EXPECT_FALSE(standing.may_be_a_mark(track));
}

TEST(CellStanding, TracksOfTheFirstFramesHaveTimeToShowThatTheyMove) {
  CellStandingParams params;
  CellStanding standing(params);
  for (int t = 0; t < params.early_frames; ++t) standing.begin(t);
  CellTrack track = track_that_went({0.0, 0.0});
  track.moving = 0.0;
  track.first_time = 1.0;
  EXPECT_FALSE(standing.stands(track));
  track.age = params.early_age;
  EXPECT_TRUE(standing.stands(track));
  track.age = params.min_age;
  track.first_time = params.early_frames;  // it began when the background was known
  EXPECT_TRUE(standing.surely_stands(track));
}

TEST(CellStanding, APlaceIsRememberedForAMinute) {
  const CellStandingParams params;
  CellStanding standing(params);
  const ScaleSpace scales = seen();
  standing.remember({50.0, 40.0}, 0.0);
  const Candidate there{0, {50.5, 40.0}, 0.0, 0.0}, elsewhere{0, {70.0, 40.0}, 0.0, 0.0};
  EXPECT_EQ(standing.first_odds(scales, kGeometry, there), params.known_odds);
  EXPECT_EQ(standing.first_odds(scales, kGeometry, elsewhere), params.moving_odds);
  standing.forget_old(params.memory + 1.0);
  EXPECT_EQ(standing.first_odds(scales, kGeometry, there), params.moving_odds);
}

TEST(CellStanding, OnlyWhatIsNewOrSurelyMovesMayBeATarget) {
  const CellStanding standing({});
  CellTrack track = track_that_went({0.0, 0.0});
  EXPECT_TRUE(standing.may_be_target(track));
  track.age = 100;
  track.moving = 0.5;
  EXPECT_FALSE(standing.may_be_target(track));
}

}  // namespace
}  // namespace lookout::tracking
