#include "csht/likelihood/scan_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/frames.hpp"

namespace lookout::csht {
namespace {

// Four beams of 10 degrees about the bow; one return at 40 m in beam 1.
core::PosedScan four_beams() {
  core::PosedScan posed;
  posed.scan.num_beams = 4;
  posed.scan.first_bearing = core::radians(-15.0);
  posed.scan.bearing_step = core::radians(10.0);
  posed.scan.max_range = 100.0;
  posed.scan.returns.push_back({core::radians(-5.0), 40.0});
  posed.T_earth_sonar = {5.0, 6.0, core::radians(90.0)};
  return posed;
}

// The same scan with P_M = .2, P_F = .5 and sigma = 2 m.
ScanTable with_figures(const SensorModelParams& model) {
  ScanTable table;
  fill_scan_table(four_beams(), table);
  set_figures({.miss_probability = 0.2, .false_alarm_probability = 0.5, .range_sigma = 2.0}, model, table);
  return table;
}

// Beam 1 is slot 2; a return behind it in the same beam and one beyond the fan have none.
TEST(ScanTable, KeepsTheNearestReturnOfABeamInItsSlot) {
  core::PosedScan posed = four_beams();
  posed.scan.returns.push_back({core::radians(-5.0), 60.0});
  posed.scan.returns.push_back({core::radians(40.0), 60.0});
  ScanTable table;
  fill_scan_table(posed, table);
  EXPECT_EQ(slot_of(table, 0), 2U);
  EXPECT_FALSE(slot_of(table, 1).has_value());
  EXPECT_FALSE(slot_of(table, 2).has_value());
  table.clutter = ClutterModel::point;
  EXPECT_EQ(slot_of(table, 2), 2U);
}

TEST(ScanTable, LaysReturnsOutByBeamWithASlotAtEitherEnd) {
  ScanTable table;
  EXPECT_EQ(fill_scan_table(four_beams(), table), 0);
  ASSERT_EQ(table.range.size(), 6U);
  EXPECT_FLOAT_EQ(table.range[2], 40.0F);
  EXPECT_TRUE(table.silent(0));
  EXPECT_FALSE(table.silent(1));
  EXPECT_NEAR(table.axis, core::radians(90.0), 1e-12);
  EXPECT_FALSE(table.whole_circle);
}

// gain = (1 - P_M) / P_F x R / (sigma sqrt(2 pi)); silence = P_M / (1 - P_F). docs/scan_likelihood.md.
TEST(ScanTable, FiguresOfTheExclusiveBeam) {
  const ScanTable table = with_figures({});
  EXPECT_NEAR(table.gain, 0.8 / 0.5 * 100.0 / (2.0 * std::sqrt(2.0 * std::numbers::pi)), 1e-4);
  EXPECT_NEAR(table.base[1], 0.2 / 0.5, 1e-6);
  EXPECT_NEAR(table.base[2], std::exp(-8.0), 1e-9);
  EXPECT_EQ(table.base.front(), 1.0F);  // Outside the sector nothing is learnt.
  EXPECT_EQ(table.base.back(), 1.0F);
}

// Of a silence, and of a return of something else, which says in an exclusive beam that no target is there.
TEST(ScanTable, WhatSilenceGainsAtTheEndOfTheRangeGate) {
  const ScanTable table = with_figures({});
  EXPECT_NEAR(table.lost[1], 0.8 / 0.5, 1e-6);
  EXPECT_EQ(table.lost[2], 0.0F);
  EXPECT_EQ(table.lost.front(), 0.0F);
  EXPECT_NEAR(lost_of(table, 1.0 / 3.0, table.max_range), 0.5, 1e-6);  // Half of the returns at the border.
  EXPECT_EQ(lost_of(with_figures({.range_gate = false}), 1.0 / 3.0, table.max_range), 0.0);
  EXPECT_EQ(with_figures({.clutter = ClutterModel::point, .range_gate = false}).lost[1], 0.0F);
}

TEST(ScanTable, AWholeCircleRepeatsTheBeamsAcrossTheSeam) {
  core::PosedScan posed = four_beams();
  posed.scan.bearing_step = core::radians(90.0);
  posed.scan.first_bearing = core::radians(-135.0);
  posed.scan.returns = {{core::radians(-135.0), 30.0}};
  ScanTable table;
  fill_scan_table(posed, table);
  EXPECT_TRUE(table.whole_circle);
  EXPECT_FLOAT_EQ(table.range[1], 30.0F);
  EXPECT_FLOAT_EQ(table.range[5], 30.0F);
}

}  // namespace
}  // namespace lookout::csht
