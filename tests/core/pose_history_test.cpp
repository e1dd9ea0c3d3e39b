#include "core/pose_history.hpp"

#include <gtest/gtest.h>

namespace lookout::core {
namespace {

VehicleState state_at(double time, Pose2 pose) {
  return {microseconds(time), pose, {0, 0}};
}

TEST(PoseHistory, InterpolatesLinearlyBetweenStates) {
  PoseHistory history;
  history.add(state_at(1.0, {0.0, 10.0, 0.2}));
  history.add(state_at(2.0, {4.0, 20.0, 0.4}));
  const auto pose = history.at(microseconds(1.25));
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->north, 1.0, 1e-9);
  EXPECT_NEAR(pose->east, 12.5, 1e-9);
  EXPECT_NEAR(pose->heading, 0.25, 1e-9);
}

TEST(PoseHistory, HeadingTakesTheShorterTurn) {
  PoseHistory history;
  history.add(state_at(0.0, {0, 0, radians(170.0)}));
  history.add(state_at(1.0, {0, 0, radians(-170.0)}));
  const auto pose = history.at(microseconds(0.25));
  ASSERT_TRUE(pose);
  EXPECT_NEAR(degrees(pose->heading), 175.0, 1e-6);
}

TEST(PoseHistory, StateAtTheExactTimeServesAlone) {
  PoseHistory history;
  history.add(state_at(5.0, {1, 2, 3}));
  ASSERT_TRUE(history.at(microseconds(5.0)));
  EXPECT_DOUBLE_EQ(history.at(microseconds(5.0))->east, 2.0);
  EXPECT_FALSE(history.at(microseconds(5.1)));
  EXPECT_FALSE(history.at(microseconds(4.9)));
}

TEST(PoseHistory, RefusesABracketAboveTwoSeconds) {
  PoseHistory history;
  history.add(state_at(0.0, {0, 0, 0}));
  history.add(state_at(2.0, {2, 0, 0}));
  history.add(state_at(4.1, {4, 0, 0}));
  EXPECT_TRUE(history.at(microseconds(1.0)));
  EXPECT_FALSE(history.at(microseconds(3.0)));
}

TEST(PoseHistory, TakesWiderBracketsWhereTold) {
  PoseHistory history(20'000'000);
  history.add(state_at(0.0, {0, 0, 0}));
  history.add(state_at(20.0, {20, 0, 0}));
  ASSERT_TRUE(history.at(microseconds(5.0)));
  EXPECT_NEAR(history.at(microseconds(5.0))->north, 5.0, 1e-9);
  EXPECT_EQ(history.gap_at(microseconds(5.0)), microseconds(20.0));
  EXPECT_FALSE(history.gap_at(microseconds(21.0)));
}

TEST(PoseHistory, TakesStatesThatCrossOneAnother) {
  PoseHistory history;
  for (const double time : {0.0, 0.2, 0.1}) history.add(state_at(time, {time * time, 0, 0}));
  EXPECT_NEAR(history.at(microseconds(0.15))->north, 0.025, 1e-9);  // Between .01 and .04.
}

TEST(PoseHistory, MemoryIsBounded) {
  PoseHistory history;
  for (int i = 0; i < 10000; ++i) history.add(state_at(0.1 * i, {0, 0, 0}));
  EXPECT_LE(history.size(), 102u);
}

TEST(PoseHistory, ReachesAndClear) {
  PoseHistory history;
  EXPECT_FALSE(history.reaches(0));
  history.add(state_at(1.0, {0, 0, 0}));
  EXPECT_TRUE(history.reaches(microseconds(1.0)));
  EXPECT_FALSE(history.reaches(microseconds(1.000001)));
  history.clear();
  EXPECT_FALSE(history.newest());
}

TEST(PoseHistory, WorksFarFromTimeZero) {
  PoseHistory history;  // 2026 on a vehicle's clock, in microseconds
  const std::int64_t now = 1'780'000'000'000'000;
  history.add({now, {0, 0, 0}, {0, 0}});
  history.add({now + 1'000'000, {1, 0, 0}, {0, 0}});
  ASSERT_TRUE(history.at(now + 250'000));
  EXPECT_NEAR(history.at(now + 250'000)->north, 0.25, 1e-6);
}

// A state every 20 s, and a scan that waits for the state behind it: the one at its own time must still be
// there.
TEST(PoseHistory, KeepsTheNewestFewHoweverFarApart) {
  PoseHistory history;
  for (int i = 0; i < 100; ++i) history.add(state_at(20.0 * i, {1.0 * i, 0, 0}));
  ASSERT_TRUE(history.at(microseconds(20.0 * 97)));
  EXPECT_NEAR(history.at(microseconds(20.0 * 97))->north, 97.0, 1e-9);
  EXPECT_LE(history.size(), 20u);
}

}  // namespace
}  // namespace lookout::core
