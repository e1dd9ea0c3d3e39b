#include "tracking/track_before_detect/frames/spot_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr int kColumns = 100;
constexpr int kRows = 80;

/// Noise over clouds, with spots of 2 px.
std::vector<double> sky(const std::vector<Eigen::Vector2d>& spots, core::Random& random, double sign = 1.0) {
  std::vector<double> grey;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      double value =
          100.0 + 20.0 * std::sin(0.07 * column) + 15.0 * std::cos(0.09 * row) + random.gaussian(3.0);
      for (const auto& spot : spots)
        value +=
            sign * 60.0 * std::exp(-0.5 * (Eigen::Vector2d(column + 0.5, row + 0.5) - spot).squaredNorm());
      grey.push_back(value);
    }
  return grey;
}

std::vector<Spot> confirmed(const std::vector<Spot>& spots) {
  std::vector<Spot> out;
  for (const Spot& spot : spots)
    if (spot.confirmed) out.push_back(spot);
  return out;
}

TEST(SpotTracker, FindsTwoTargetsOfWhichOneHardlyMoves) {
  core::Random random(1000);
  SpotTracker tracker;
  std::vector<Spot> spots;
  for (int k = 0; k < 15; ++k)
    spots = confirmed(
        tracker.update(sky({{30.0 + 0.1 * k, 20.0}, {70.0 - 1.5 * k, 60.0}}, random), kColumns, kRows, 1.0));
  ASSERT_EQ(spots.size(), 2u);
  const Eigen::Vector2d slow(31.4, 20.0), quick(49.0, 60.0);
  for (const Spot& spot : spots)
    EXPECT_LT(std::min((spot.position - slow).norm(), (spot.position - quick).norm()), 1.5);
}

TEST(SpotTracker, AnEmptySkyHoldsNoTarget) {
  core::Random random(1001);
  SpotTracker tracker;
  for (int k = 0; k < 30; ++k)
    EXPECT_TRUE(confirmed(tracker.update(sky({}, random), kColumns, kRows, 1.0)).empty()) << k;
}

TEST(SpotTracker, ADarkTargetIsFoundWhereItIsAskedFor) {
  core::Random random(1002);
  SpotParams params;
  params.polarity = Polarity::dark;
  SpotTracker tracker(params);
  std::vector<Spot> spots;
  for (int k = 0; k < 6; ++k)
    spots = confirmed(tracker.update(sky({{40.0, 30.0}}, random, -1.0), kColumns, kRows, 1.0));
  ASSERT_EQ(spots.size(), 1u);
  EXPECT_LT((spots[0].position - Eigen::Vector2d(40.0, 30.0)).norm(), 1.5);
}

TEST(SpotTracker, ATargetThatGoesEnds) {
  core::Random random(1003);
  SpotTracker tracker;
  for (int k = 0; k < 10; ++k) tracker.update(sky({{40.0, 30.0}}, random), kColumns, kRows, 1.0);
  std::vector<Spot> spots;
  for (int k = 0; k < 12; ++k) spots = confirmed(tracker.update(sky({}, random), kColumns, kRows, 1.0));
  EXPECT_TRUE(spots.empty());
}

TEST(SpotTracker, RefusesParametersOutOfRange) {
  SpotParams params;
  params.evidence_memory = 1.0;
  EXPECT_THROW(SpotTracker{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
