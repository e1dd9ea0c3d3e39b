#include "tracking/intake/pose_guard.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr double kStep = 0.25;    // s between two states
constexpr double kSpeed = 2.0;    // m/s, northward
constexpr double kHeading = 0.5;  // rad

/// What is said, as a vehicle would be without a fault.
struct Story {
  double factor = 1.0;  ///< Of the position.
  double heading = kHeading;
  double velocity = kSpeed;
};

core::VehicleState at(double second, const Story& story) {
  return {core::microseconds(second),
          {story.factor * (100.0 + kSpeed * second), 0.0, story.heading},
          {story.velocity, 0.0}};
}

/// How many of the states of [from, to) [s] are doubted.
int doubted(PoseGuard& guard, double from, double to, const Story& story = {}) {
  int count = 0;
  for (double second = from; second < to; second += kStep)
    count += guard.doubt(at(second, story)).empty() ? 0 : 1;
  return count;
}

TEST(PoseGuard, DoubtsAPositionThatLeapsUntilItIsBack) {
  PoseGuard guard;
  EXPECT_EQ(doubted(guard, 0.0, 40.0), 0);
  EXPECT_EQ(doubted(guard, 40.0, 55.0, {.factor = 10.0}), 60);  // All of 15 s.
  EXPECT_EQ(doubted(guard, 55.0, 60.0), 0);
}

TEST(PoseGuard, ReckonsOnWhereNoVelocityIsGiven) {
  PoseGuard guard;
  EXPECT_EQ(doubted(guard, 0.0, 40.0, {.velocity = 0.0}), 0);
  EXPECT_EQ(doubted(guard, 40.0, 55.0, {.factor = 10.0, .velocity = 0.0}), 60);
  EXPECT_EQ(doubted(guard, 55.0, 60.0, {.velocity = 0.0}), 0);
}

TEST(PoseGuard, DoubtsAHeadingInDegrees) {
  PoseGuard guard;
  EXPECT_EQ(doubted(guard, 0.0, 40.0), 0);
  EXPECT_EQ(guard.doubt(at(40.0, {.heading = 28.6})),
            "its heading leaps, faster than a vehicle turns: degrees?");
  EXPECT_EQ(doubted(guard, 40.25, 55.0, {.heading = 28.6}), 59);
  EXPECT_EQ(doubted(guard, 55.0, 60.0), 0);
}

TEST(PoseGuard, AHeadingMayTurnAndWrap) {
  PoseGuard guard;
  for (int i = 0; i < 100; ++i)  // 60 degrees a second, in and out of (-pi, pi].
    EXPECT_EQ(guard.doubt(at(kStep * i, {.heading = core::wrap_to_pi(0.26 * i)})), "") << i;
}

TEST(PoseGuard, WhileTheHeadingIsDoubtedThePositionGoesOn) {
  PoseGuard guard;
  doubted(guard, 0.0, 40.0);
  doubted(guard, 40.0, 50.0, {.heading = 3.5, .velocity = 0.0});
  EXPECT_EQ(doubted(guard, 50.0, 55.0), 0);
}

TEST(PoseGuard, OneDamagedFixIsDoubtedAlone) {
  PoseGuard guard;
  doubted(guard, 0.0, 10.0);
  EXPECT_EQ(doubted(guard, 10.0, 10.25, {.factor = -50.0}), 1);
  EXPECT_EQ(doubted(guard, 10.25, 20.0), 0);
}

TEST(PoseGuard, ALateStateIsJudgedAndMovesNothing) {
  PoseGuard guard;
  doubted(guard, 0.0, 10.0);
  EXPECT_EQ(guard.doubt(at(9.6, {})), "");
  EXPECT_NE(guard.doubt(at(9.55, {.factor = 10.0})), "");
  EXPECT_EQ(doubted(guard, 10.0, 20.0), 0);
}

TEST(PoseGuard, ACorrectionASilenceAndANewClockAreNoLeaps) {
  PoseGuard guard;
  doubted(guard, 0.0, 10.0);
  EXPECT_EQ(guard.doubt(at(10.0, {.factor = 1.125})), "");                // A fix, by 15 m.
  EXPECT_EQ(guard.doubt(at(13.0, {.factor = 5.0, .heading = 2.5})), "");  // 3 s of silence.
  guard.forget();
  EXPECT_EQ(guard.doubt(at(13.25, {.factor = -90.0})), "");
}

}  // namespace
}  // namespace lookout::tracking
