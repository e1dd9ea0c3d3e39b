#include "fusion/fusion_params.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"

namespace lookout::fusion {
namespace {

FusionParams read(const std::string& text) {
  return testing::read_yaml(read_fusion_params, text);
}

TEST(FusionParams, ReadsItsKeys) {
  const auto params = read(
      "{support: col, unit: m, origin: node, node_north: 21.0, node_east: 24.0, association: max, method: "
      "ci, "
      "position_scale: 7.5, bearing_sigma_deg: 0.5, coast_s: 4.0}");
  EXPECT_EQ(params.support_degree.reading, SupportReading::col);
  EXPECT_EQ(params.support_degree.length_unit, 1.0);
  EXPECT_EQ(params.support_degree.p_earth_origin, Eigen::Vector2d(21.0, 24.0));
  EXPECT_EQ(params.association.rule, AssociationRule::max);
  EXPECT_EQ(params.association.position_scale, 7.5);
  EXPECT_EQ(params.method, "ci");
  EXPECT_NEAR(params.learned.bearing_sigma, core::radians(0.5), 1e-15);
  EXPECT_EQ(params.global.coast, 4.0);
}

TEST(FusionParams, ReadsTheTolerancesOfClockLinkAndRate) {
  const auto params = read(
      "{clock_tolerance_s: 2, max_delay_s: 40, max_interval_s: 90, max_age_s: 50, max_gap_s: 70, "
      "max_silence_s: 80, process_noise: 0.5}");
  EXPECT_EQ(params.clock.tolerance, 2.0);
  EXPECT_EQ(params.clock.max_delay, 40.0);
  EXPECT_EQ(params.clock.max_interval, 90.0);
  EXPECT_EQ(params.store.max_age, 50.0);
  EXPECT_EQ(params.store.max_gap, 70.0);
  EXPECT_EQ(params.store.max_silence, 80.0);
  EXPECT_EQ(params.global.process_noise, 0.5);
  EXPECT_THROW(read("{max_delay_s: 1}"), core::InputError);
}

TEST(FusionParams, TheContractsExampleIsTheDefault) {
  const auto params = read("{support: any, unit: km, origin: zero, association: one_to_one}");
  EXPECT_EQ(params.support_degree.length_unit, 1000.0);
  EXPECT_EQ(params.association.rule, AssociationRule::one_to_one);
  EXPECT_EQ(params.method, "learned");
}

TEST(FusionParams, RefusesUnknownKeysAndValues) {
  EXPECT_THROW(read("{suport: any}"), core::InputError);
  EXPECT_THROW(read("{support: most}"), core::InputError);
  EXPECT_THROW(read("{method: vote}"), core::InputError);
  EXPECT_THROW(read("{position_scale: 0}"), core::InputError);
}

}  // namespace
}  // namespace lookout::fusion
