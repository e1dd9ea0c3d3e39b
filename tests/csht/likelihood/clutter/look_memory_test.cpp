#include "csht/likelihood/clutter/look_memory.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr double kReach = 4.0;

LookMemory::Limits limits(std::size_t most_looks, std::size_t most_returns = 16) {
  return {kSecond, most_looks, most_returns, kReach};
}

// Returns dead ahead of a sonar at `north` that looks north, at these ranges.
const ScanTable& scan_ahead(ScanHistory& history, std::int64_t utime, double north,
                            const std::vector<double>& ranges) {
  std::vector<core::SonarReturn> returns;
  for (std::size_t j = 0; j < ranges.size(); ++j)
    returns.push_back({core::radians(-44.5 + 45.0 + static_cast<double>(j)), ranges[j], 1});
  history.push(posed_scan(returns, utime, {north, 0.0, core::radians(-0.5)}));
  return history.newest();
}

TEST(LookMemory, KeepsAReturnInBothFrames) {
  ScanHistory history({}, {}, 1);
  LookMemory memory(limits(3));
  ASSERT_TRUE(memory.add(scan_ahead(history, 0, 7.0, {60.0})));
  ASSERT_EQ(memory.looks().size(), 1u);
  const Look& look = memory.looks().front();
  ASSERT_EQ(look.earth.size(), 1u);
  EXPECT_NEAR(static_cast<double>(look.earth[0].x), 67.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(look.earth[0].y), 0.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(look.in_sonar[0].x), 0.5, 1e-4);  // Beam 45 of 90 is half a beam right.
  EXPECT_NEAR(static_cast<double>(look.in_sonar[0].y), 60.0 / kReach, 1e-4);
}

TEST(LookMemory, FindsItsReturnsInTheBinsOfBothFrames) {
  ScanHistory history({}, {}, 1);
  LookMemory memory(limits(3));
  memory.add(scan_ahead(history, 0, 0.0, {60.0}));
  memory.add(scan_ahead(history, kSecond, 10.0, {50.0}));  // The same place of the earth.
  int in_earth = 0, in_sonar = 0;
  memory.earth().visit(60.0, 0.0, 1.0, 1.0, [&](const BinnedPoint& p) {
    EXPECT_EQ(p.look, in_earth);
    ++in_earth;
  });
  memory.in_sonar().visit(0.5, 50.0 / kReach, 0.1, 0.1, [&](const BinnedPoint& p) {
    EXPECT_EQ(p.look, 1);
    ++in_sonar;
  });
  EXPECT_EQ(in_earth, 2);
  EXPECT_EQ(in_sonar, 1);
}

TEST(LookMemory, ThinsOutScansThatFollowFaster) {
  ScanHistory history({}, {}, 1);
  LookMemory memory(limits(3));
  EXPECT_TRUE(memory.add(scan_ahead(history, 0, 0.0, {60.0})));
  EXPECT_FALSE(memory.add(scan_ahead(history, kSecond - 1, 0.0, {60.0})));
  EXPECT_TRUE(memory.add(scan_ahead(history, kSecond, 0.0, {60.0})));
  EXPECT_EQ(memory.looks().size(), 2u);
}

TEST(LookMemory, OfMoreLooksTheOldestGo) {
  ScanHistory history({}, {}, 1);
  LookMemory memory(limits(2));
  for (int k = 0; k < 5; ++k) memory.add(scan_ahead(history, k * kSecond, 0.0, {60.0}));
  ASSERT_EQ(memory.looks().size(), 2u);
  EXPECT_EQ(memory.looks()[0].utime, 3 * kSecond);
  EXPECT_EQ(memory.looks()[1].number, 4);
  int points = 0;
  memory.earth().visit(60.0, 0.0, 1.0, 1.0, [&](const BinnedPoint&) { ++points; });
  EXPECT_EQ(points, 2);
}

// Ten returns where four are kept: every third, each for three.
TEST(LookMemory, OfManyReturnsEvenlySpacedOnesStandForAll) {
  ScanHistory history({}, {}, 1);
  LookMemory memory(limits(2, 4));
  memory.add(scan_ahead(history, 0, 0.0, {10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
  const Look& look = memory.looks().front();
  ASSERT_EQ(look.earth.size(), 4u);
  for (const BinnedPoint& p : look.earth) EXPECT_EQ(p.weight, 3.0F);
  EXPECT_EQ(memory.look_at(history.newest()), nullptr);  // Not all were taken.
}

TEST(LookMemory, GivesTheLookAtAScanOfItsOwnTime) {
  ScanHistory history({}, {}, 2);
  LookMemory memory(limits(2));
  memory.add(scan_ahead(history, 0, 0.0, {60.0}));
  ASSERT_NE(memory.look_at(history.newest()), nullptr);
  scan_ahead(history, kSecond / 2, 0.0, {60.0});
  EXPECT_EQ(memory.look_at(history.newest()), nullptr);
}

// From a sonar 10 m further north the same beam and range are 10 m further north too.
TEST(LookMemory, CarriesAPlaceOfTheSonarsFrameAlong) {
  ScanHistory history({}, {}, 2);
  LookMemory memory(limits(2));
  memory.add(scan_ahead(history, 0, 0.0, {60.0}));
  const ScanTable& later = scan_ahead(history, kSecond, 10.0, {});
  const SeenPlace carried = memory.place_around(later, memory.looks().front().in_sonar[0]);
  EXPECT_NEAR(carried.p_earth.x(), 70.0, 1e-4);
  EXPECT_NEAR(carried.range, 60.0, 1e-4);
  const SeenPlace standing = seen_place(later, Eigen::Vector2d{60.0, 0.0});
  EXPECT_NEAR(standing.range, 50.0, 1e-9);
  EXPECT_NEAR(standing.beam, 0.5, 1e-6);
}

}  // namespace
}  // namespace lookout::csht
