#include "tests/tracking/intake/intake_bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lookout::tracking {
namespace {

class IntakeGuardsTest : public IntakeBench {};

TEST_F(IntakeGuardsTest, LeavesOutAScanWhoseReturnsSuddenlyLieOutside) {
  for (int i = 0; i < 20; ++i) {
    auto ping = scan(i * kSecond, i);
    for (int k = 0; k < 6; ++k)
      ping.returns.push_back({0.1 * k, (i == 15 ? 100.0 : 10.0) * (k + 2) + i, 1.0});
    state(ping.utime);
    intake_.add(ping);
  }
  EXPECT_EQ(counts().contradicting, 1);
  EXPECT_EQ(counts().accepted, 19);
  EXPECT_EQ(counts().returns, 19 * 6);
}

// Two senders: nothing is lost, but the numbers go to and fro. Of the second three are taken, two are not.
TEST_F(IntakeGuardsTest, CountsNumbersThatGoToAndFroAndLeavesTheSecondSenderOut) {
  for (int i = 0; i < 10; ++i) {
    next_sequence_ = i % 2 == 0 ? 1000 + i / 2 : i / 2;
    surrounded_scan(i * kSecond);
  }
  EXPECT_EQ(counts().lost, 0);
  EXPECT_EQ(counts().backwards, 3);
  EXPECT_EQ(counts().foreign, 2);
  EXPECT_EQ(counts().accepted, 8);
}

TEST_F(IntakeGuardsTest, CountsHeadingsThatNoRadianHas) {
  intake_.add(core::VehicleState{0, {0.0, 0.0, 6.0}, {0.0, 0.0}});
  intake_.add(core::VehicleState{kSecond, {0.0, 0.0, 30.0}, {0.0, 0.0}});
  EXPECT_EQ(counts().wide_headings, 1);
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_EQ(reports_[0],
            "vehicle state at 1 s has a heading of 30 rad, beyond two turns: degrees? (1 so far)");
  EXPECT_EQ(counts().accepted_states, 2);
}

// The first repeat may be chance; from the second on nothing is learnt of them.
TEST_F(IntakeGuardsTest, TellsOfASensorThatIsFrozenAndLeavesItOut) {
  auto ping = scan(0, 0);
  ping.returns = {{0.0, 10.0, 1.0}, {0.1, 20.0, 1.0}, {0.2, 30.0, 1.0}};
  for (int i = 0; i < 5; ++i) {
    ping.utime = i * kSecond;
    ping.sequence = i;
    state(ping.utime);
    intake_.add(ping);
  }
  EXPECT_EQ(counts().accepted, 2);
  EXPECT_EQ(counts().frozen, 3);
  EXPECT_EQ(counts().rejected(), 3);
  EXPECT_EQ(counts().repeated, 4);
  EXPECT_EQ(reports_.size(), 5u);  // Repeats 1, 2 and 4, rejections 1 and 2.
}

// Each scan comes twice, the second time stamped a millisecond later and numbered on.
TEST_F(IntakeGuardsTest, RefusesTheDoubleOfAScanUnderALaterStamp) {
  for (int i = 0; i < 8; ++i) {
    const int pair = i / 2;
    auto ping = scan(pair * kSecond + i % 2 * kSecond / 1000, i);
    ping.returns = {{0.0, 10.0 + pair, 1.0}, {0.1, 20.0, 1.0}, {0.2, 30.0, 1.0}};
    state(ping.utime);
    intake_.add(ping);
  }
  EXPECT_EQ(counts().accepted, 4);
  EXPECT_EQ(counts().frozen, 4);
  EXPECT_EQ(counts().lost, 0);
}

// 2,000 returns in ninety beams, none of which rings: 512 are taken.
TEST_F(IntakeGuardsTest, LeavesOutWhatACrowdedScanHoldsTooMuch) {
  auto crowded = scan(kSecond, 0);
  for (int i = 0; i < 2000; ++i)
    crowded.returns.push_back({crowded.first_bearing + i % 90 * crowded.bearing_step, 20.0 + 0.05 * i, 1.0});
  state(kSecond);
  intake_.add(crowded);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].scan.returns.size(), 512u);
  EXPECT_EQ(counts().returns, 2000);
  EXPECT_EQ(counts().shed_returns, 1488);
  EXPECT_EQ(counts().crowded, 1);
  EXPECT_EQ(counts().returns_behind, 512 - 90);
}

TEST_F(IntakeGuardsTest, CountsLossAndRestartBySequence) {
  surrounded_scan(kSecond);
  next_sequence_ = 4;
  surrounded_scan(2 * kSecond);
  EXPECT_EQ(counts().lost, 3);
  next_sequence_ = 0;
  surrounded_scan(3 * kSecond);
  EXPECT_EQ(counts().restarts, 1);
  EXPECT_EQ(counts().accepted, 3);
}

TEST_F(IntakeGuardsTest, DropsReturnsOutOfBoundsAndKeepsTheScan) {
  auto far = scan(kSecond, 0);
  far.returns = {{0.0, 150.5, 1.0}, {0.0, 149.5, 1.0}};
  state(kSecond);
  intake_.add(far);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].scan.returns.size(), 1u);
  EXPECT_EQ(counts().dropped_returns, 1);
}

TEST_F(IntakeGuardsTest, NinetyReturnsThatAreAllNanAreNinetySilences) {
  auto silent = scan(kSecond, 0);
  silent.returns.assign(
      90, {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 1.0});
  state(kSecond);
  intake_.add(silent);
  EXPECT_EQ(counts().silent_returns, 90);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_TRUE(out_[0].scan.returns.empty());
}

TEST_F(IntakeGuardsTest, LetsTheGeometryOfTheMessageWinAndSaysSo) {
  auto other = scan(kSecond, 0);
  other.max_range = 75.0;
  state(kSecond);
  intake_.add(other);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].scan.max_range, 75.0);
  EXPECT_EQ(counts().other_geometry, 1);
  EXPECT_EQ(reports_.size(), 1u);
}

// Table 1's outer beams, the 88 between them even in the sine: a message can only say the mean.
TEST_F(IntakeGuardsTest, BeamsThatAreEvenInSineAreFoundAndToldOnce) {
  const double outer = std::sin(core::radians(44.5));
  for (int i = 0; i < 8; ++i) {
    core::SonarScan one = scan(i * kSecond, i);
    for (const int beam : {10 + i, 40 + i})
      one.returns.push_back({std::asin(outer * (2.0 * beam / 89.0 - 1.0)), 50.0 + i, 1.0});
    state(i * kSecond);
    intake_.add(one);
  }
  ASSERT_EQ(out_.size(), 8u);
  EXPECT_FALSE(out_.front().scan.fan);
  ASSERT_TRUE(out_.back().scan.fan);
  EXPECT_NEAR(out_.back().scan.fan->place_of(out_.back().scan.returns[0].bearing), 17.0, 1e-6);
  EXPECT_EQ(std::count_if(reports_.begin(), reports_.end(),
                          [](const auto& line) { return line.find("even in sine") != std::string::npos; }),
            1);
}

}  // namespace
}  // namespace lookout::tracking
