#include "tracking/intake/pose_intake.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

class PoseIntakeTest : public ::testing::Test {
 protected:
  void add(std::int64_t utime) { intake_.add({utime, {core::seconds(utime), 0.0, 0.0}, {0.0, 0.0}}); }

  std::vector<std::int64_t> refused_;
  std::vector<std::int64_t> believed_;
  int new_clocks_ = 0;
  PoseIntake intake_{
      {[this](const core::VehicleState& state, std::string_view) { refused_.push_back(state.utime); },
       [this](const core::VehicleState& state, bool new_clock) {
         believed_.push_back(state.utime);
         if (new_clock) ++new_clocks_;
       }},
      core::PoseHistory::kMaxBracket,
      {}};
};

TEST_F(PoseIntakeTest, TakesStatesThatCrossAndRepeat) {
  for (const std::int64_t tenths : {0, 2, 1, 3, 3}) add(tenths * kSecond / 10);
  EXPECT_EQ(believed_.size(), 5u);
  EXPECT_TRUE(refused_.empty());
  EXPECT_TRUE(intake_.poses().at(kSecond / 20));
}

TEST_F(PoseIntakeTest, RefusesAPoseThatStandsWhileItSaysThatItMoves) {
  for (int i = 0; i < 4; ++i) intake_.add({i * kSecond / 4, {1.0, 2.0, 0.5}, {0.5, 0.0}});
  EXPECT_EQ(refused_.size(), 3u);
  intake_.add({kSecond, {1.5, 2.0, 0.5}, {0.5, 0.0}});
  EXPECT_EQ(believed_.size(), 2u);
}

TEST_F(PoseIntakeTest, RefusesPositionsThatLeapUntilANewClock) {
  const auto add_at = [this](double second, double north) {
    intake_.add({core::microseconds(second), {north, 0.0, 0.0}, {1.0, 0.0}});
  };
  for (int i = 0; i < 20; ++i) add_at(100.0 + i, i);
  for (int i = 20; i < 25; ++i) add_at(100.0 + i, 10.0 * (100.0 + i));
  EXPECT_EQ(refused_.size(), 5u);
  EXPECT_FALSE(intake_.poses().at(core::microseconds(120.5)));
  for (int i = 0; i < 5; ++i) add_at(i, 1000.0 + i);
  EXPECT_EQ(refused_.size(), 5u);
  EXPECT_TRUE(intake_.poses().at(core::microseconds(0.5)));
}

TEST_F(PoseIntakeTest, AVehicleMayRest) {
  for (int i = 0; i < 4; ++i) intake_.add({i * kSecond, {1.0, 2.0, 0.5}, {0.0, 0.0}});
  EXPECT_TRUE(refused_.empty());
}

TEST_F(PoseIntakeTest, OneBadStampIsRefusedAlone) {
  for (const std::int64_t second : {0, 1, 5, 2, 3}) add(second * kSecond);
  EXPECT_EQ(refused_, std::vector<std::int64_t>{5 * kSecond});
  EXPECT_EQ(believed_.size(), 4u);
}

TEST_F(PoseIntakeTest, ANewClockBeginsWithTheStatesThatShowedIt) {
  for (int i = 100; i < 105; ++i) add(i * kSecond);
  for (int i = 0; i < 5; ++i) add(i * kSecond);
  EXPECT_EQ(new_clocks_, 1);
  EXPECT_TRUE(refused_.empty());
  EXPECT_EQ(intake_.poses().size(), 5u);
  EXPECT_TRUE(intake_.poses().at(0));
}

TEST_F(PoseIntakeTest, AtTheEndBelievesAStateAfterAPause) {
  add(0);
  add(3 * kSecond);
  EXPECT_EQ(believed_.size(), 1u);
  intake_.finish();
  EXPECT_EQ(believed_.size(), 2u);
}

}  // namespace
}  // namespace lookout::tracking
