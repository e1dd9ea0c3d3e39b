#include "tracking/metrics/ospa2.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/metrics/trajectory_examples.hpp"

namespace lookout::tracking {
namespace {

using tests::trajectories;

constexpr TimeWindow kTen{0, 9};

TEST(Ospa2, EqualSetsAndEmptySetsCostNothing) {
  const auto set = trajectories({{1, {0, 0}, 0, 9}, {2, {50, 0}, 3, 6}}, 10);
  EXPECT_EQ(Ospa2()(set, set, kTen).total, 0.0);
  EXPECT_EQ(Ospa2()({}, {}, kTen).total, 0.0);
  EXPECT_EQ(Ospa2()(set, {}, kTen).total, 20.0);
}

TEST(Ospa2, AConstantOffsetIsTheDistance) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}}, 10);
  EXPECT_NEAR(Ospa2()(truth, trajectories({{9, {3, 4}, 0, 9}}, 10), kTen).total, 5.0, 1e-12);
}

// The track lives four of ten times: the mean of 4 x 0 m and 6 x 20 m is 12 m.
TEST(Ospa2, ATrackThatIsLateCostsTheCutoffWhileItIsNot) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}}, 10);
  EXPECT_NEAR(Ospa2()(truth, trajectories({{9, {0, 0}, 6, 9}}, 10), kTen).total, 12.0, 1e-12);
}

// Two halves of one target: OSPA is 0 at every time; here one half is 10 m from the target, one is too many:
// total^2 = (10^2 + 20^2) / 2.
TEST(Ospa2, ABrokenTrackCostsWhatPlainOspaDoesNotSee) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}}, 10);
  const auto broken = trajectories({{8, {0, 0}, 0, 4}, {9, {0, 0}, 5, 9}}, 10);
  const OspaResult result = Ospa2()(truth, broken, kTen);
  EXPECT_NEAR(result.total, std::sqrt(250.0), 1e-12);
  EXPECT_NEAR(result.localization, std::sqrt(50.0), 1e-12);
  EXPECT_NEAR(result.cardinality, std::sqrt(200.0), 1e-12);
}

TEST(Ospa2, OnlyTheWindowCounts) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}}, 10);
  const auto broken = trajectories({{8, {0, 0}, 0, 4}, {9, {0, 0}, 5, 9}}, 10);
  EXPECT_EQ(Ospa2()(truth, broken, {0, 4}).total, 0.0);
  EXPECT_EQ(Ospa2()(truth, broken, {5, 9}).total, 0.0);
}

// Two targets whose tracks change places half way: each track is 5 x 0 m and 5 x 20 m from either: 10 m.
TEST(Ospa2, ASwapOfIdentitiesCosts) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}, {2, {100, 0}, 0, 9}}, 10);
  const auto swapped =
      trajectories({{8, {0, 0}, 0, 4}, {8, {100, 0}, 5, 9}, {9, {100, 0}, 0, 4}, {9, {0, 0}, 5, 9}}, 10);
  EXPECT_NEAR(Ospa2()(truth, swapped, kTen).total, 10.0, 1e-12);
}

}  // namespace
}  // namespace lookout::tracking
