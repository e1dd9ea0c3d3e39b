#include "tracking/management/track_life.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

using core::TrackStatus;

constexpr TrackLifeParams kTwoOfThree{.confirm_hits = 2, .confirm_scans = 3};

TrackLife::Evidence hit(std::int64_t utime) {
  return {utime, 1.0, true};
}
TrackLife::Evidence miss(std::int64_t utime) {
  return {utime, 0.0, true};
}
TrackLife::Evidence outside(std::int64_t utime) {
  return {utime, 0.0, false};
}

TEST(TrackLife, OneHitConfirmsWhereOneIsAskedFor) {
  EXPECT_EQ(TrackLife({}, 0).status(), TrackStatus::confirmed);
}

TEST(TrackLife, TheMthHitConfirms) {
  TrackLife life(kTwoOfThree, 0);
  EXPECT_EQ(life.status(), TrackStatus::tentative);
  life.step(kTwoOfThree, miss(1));
  EXPECT_FALSE(life.ended());
  life.step(kTwoOfThree, hit(2));
  EXPECT_EQ(life.status(), TrackStatus::confirmed);
}

TEST(TrackLife, EndsWhenMCanNoLongerBeReached) {
  TrackLife life(kTwoOfThree, 0);
  life.step(kTwoOfThree, miss(1));
  life.step(kTwoOfThree, miss(2));
  EXPECT_TRUE(life.ended());
}

TrackLife::Evidence part(std::int64_t utime) {
  return {utime, 0.25, true};
}

// 1 + 3 x .25 are less than 2, 1 + 4 x .25 are not; none of the four is a scan without support.
TEST(TrackLife, HitsAmongDenseReturnsConfirmMoreSlowly) {
  TrackLife life(kTwoOfThree, 0);
  for (int k = 1; k <= 3; ++k) life.step(kTwoOfThree, part(k));
  EXPECT_EQ(life.status(), TrackStatus::tentative);
  EXPECT_FALSE(life.ended());
  life.step(kTwoOfThree, part(4));
  EXPECT_EQ(life.status(), TrackStatus::confirmed);
}

TEST(TrackLife, AFirstHitAmongDenseReturnsCountsForItsPart) {
  TrackLife life(kTwoOfThree, 0, 0.25);
  life.step(kTwoOfThree, hit(1));
  EXPECT_EQ(life.status(), TrackStatus::tentative);
  life.step(kTwoOfThree, hit(2));
  EXPECT_EQ(life.status(), TrackStatus::confirmed);
}

// Misses in a row m follow (1 - .25) (m + 1): .75, 1.3125, 1.73, ... up to 3.
TEST(TrackLife, SupportAmongDenseReturnsTakesBackAPartOfTheMisses) {
  constexpr TrackLifeParams kTwoMisses{.max_misses = 2.0, .first_misses = 2.0};
  TrackLife life(kTwoMisses, 0);
  for (int k = 1; k <= 3; ++k) life.step(kTwoMisses, part(k));
  EXPECT_DOUBLE_EQ(life.misses(), 0.75 * (1.3125 + 1.0));
  EXPECT_FALSE(life.ended());
  life.step(kTwoMisses, part(4));
  EXPECT_TRUE(life.ended());
}

/// Misses that a confirmed track with this many hits survives.
int survived_misses(int hits) {
  const TrackLifeParams params;
  TrackLife life(params, 0);
  for (int k = 1; k < hits; ++k) life.step(params, hit(k));
  int survived = -1;
  for (int k = hits; !life.ended(); ++k, ++survived) life.step(params, miss(k));
  return survived;
}

TEST(TrackLife, DropRuleGrowsWithTheHitsUpToFive) {
  EXPECT_EQ(survived_misses(1), 1);    // 1 + .2
  EXPECT_EQ(survived_misses(5), 2);    // 1 + 1
  EXPECT_EQ(survived_misses(12), 3);   // 1 + 2.4
  EXPECT_EQ(survived_misses(100), 5);  // min(5, 21)
}

TEST(TrackLife, CoastsOutsideTheFieldForItsTime) {
  const TrackLifeParams params{.coast_s = 2.0};
  TrackLife life(params, 0);
  life.step(params, outside(1'000'000));
  EXPECT_EQ(life.status(), TrackStatus::coasting);
  life.step(params, outside(2'999'999));
  EXPECT_FALSE(life.ended());
  life.step(params, outside(3'000'000));
  EXPECT_TRUE(life.ended());
}

TEST(TrackLife, ComesBackFromCoastingWithItsMisses) {
  const TrackLifeParams params;
  TrackLife life(params, 0);
  life.step(params, outside(1));
  life.step(params, hit(2));
  EXPECT_EQ(life.status(), TrackStatus::confirmed);
  EXPECT_EQ(life.hits(), 2);
}

TEST(TrackLife, RefusesParametersOutOfRange) {
  EXPECT_THROW((TrackLifeParams{.confirm_hits = 0}.validate()), std::invalid_argument);
  EXPECT_THROW((TrackLifeParams{.confirm_hits = 3, .confirm_scans = 2}.validate()), std::invalid_argument);
  EXPECT_THROW((TrackLifeParams{.coast_s = -1.0}.validate()), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
