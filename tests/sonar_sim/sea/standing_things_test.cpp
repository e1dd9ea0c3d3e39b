#include "sonar_sim/sea/standing_things.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

using core::radians;

TEST(StandingThings, APointIsHeardInItsBeamWithTheSonarsNoise) {
  const Ping ping = ping_at_origin();
  core::Random random(1);
  StandingPlan plan;
  plan.points = {{{60.0, 0.5}, {0.7, std::nullopt, 20.0}}};  // .48 degrees to starboard: beam 45
  double number = 0.0, squares = 0.0;
  for (int k = 0; k < kPings; ++k)
    for (const auto& one : draw_standing(plan, ping, random)) {
      ASSERT_EQ(one.beam, 45);
      ASSERT_EQ(one.source, Source::standing);
      ASSERT_EQ(one.snr_db, 20.0);
      squares += std::pow(one.measured.range - std::hypot(60.0, 0.5), 2);
      ++number;
    }
  EXPECT_NEAR(number / kPings, 0.7, rate_tolerance(0.7, kPings));
  EXPECT_NEAR(squares / number, 9.0, variance_tolerance(3.0, number));
}

TEST(StandingThings, ARayMeetsALineWhereGeometrySays) {
  const StandingLine wall{{0.0, 60.0}, {100.0, 60.0}, {}};  // 100 m along north, 60 m to the east
  EXPECT_NEAR(*range_to(wall, {0.0, 0.0}, radians(45.0)), 60.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(*range_to(wall, {10.0, 0.0}, radians(90.0)), 60.0, 1e-9);
  EXPECT_FALSE(range_to(wall, {0.0, 0.0}, radians(30.0)));   // passes north of it, tan 30 = 60 / 104
  EXPECT_FALSE(range_to(wall, {0.0, 0.0}, radians(225.0)));  // behind
  EXPECT_FALSE(range_to(wall, {0.0, 0.0}, 0.0));             // along it
}

TEST(StandingThings, ARayMeetsAnArcOnItsNearSideFirst) {
  const StandingArc ring{{100.0, 0.0}, 20.0, 0.0, 2.0 * std::numbers::pi, {}};
  EXPECT_NEAR(*range_to(ring, {0.0, 0.0}, 0.0), 80.0, 1e-9);
  EXPECT_NEAR(*range_to(ring, {100.0, 0.0}, 1.0), 20.0, 1e-9);  // from its centre
  EXPECT_FALSE(range_to(ring, {0.0, 0.0}, radians(12.0)));      // 20.8 m beside the centre
  const StandingArc north_half{{100.0, 0.0}, 20.0, radians(-90.0), radians(90.0), {}};
  EXPECT_NEAR(*range_to(north_half, {0.0, 0.0}, 0.0), 120.0, 1e-9);
}

TEST(StandingThings, AWallIsHeardInEachBeamThatMeetsIt) {
  Ping ping = ping_at_origin();
  core::Random random(2);
  StandingPlan plan;
  // Before the sonar at 50 m, 30 m to either side: beams within atan(.6) = 30.96 degrees, 62 of them.
  plan.lines = {{{50.0, -30.0}, {50.0, 30.0}, {0.8, 0.0, std::nullopt}}};
  double number = 0.0;
  for (int k = 0; k < kPings / 20; ++k)
    for (const auto& one : draw_standing(plan, ping, random)) {
      ASSERT_NEAR(one.measured.range * std::cos(one.measured.bearing), 50.0, 1e-9);
      ++number;
    }
  EXPECT_NEAR(number / (kPings / 20 * 62.0), 0.8, rate_tolerance(0.8, kPings / 20 * 62.0));
}

TEST(StandingThings, StandStillWhileTheSonarMoves) {
  Ping ping = ping_at_origin();
  core::Random random(3);
  StandingPlan plan;
  plan.points = {{{60.0, 10.0}, {1.0, 0.0, std::nullopt}}};
  ping.T_earth_sonar = {20.0, 10.0, radians(10.0)};
  const auto heard = draw_standing(plan, ping, random);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_NEAR(heard[0].measured.range, 40.0, 1e-9);
  EXPECT_EQ(heard[0].beam, ping.params.beam_of(radians(-10.0)));
}

TEST(StandingThings, AFieldFillsItsRectangle) {
  core::Random random(4);
  StandingPlan plan;
  plan.fields = {{10'000, {0.0, -70.0}, {140.0, 70.0}, {}}};
  const auto placed = place_fields(plan, random);
  ASSERT_EQ(placed.points.size(), 10'000u);
  EXPECT_TRUE(placed.fields.empty());
  Eigen::Vector2d sum{0, 0};
  for (const auto& point : placed.points) {
    ASSERT_TRUE(point.position.x() >= 0.0 && point.position.x() < 140.0);
    ASSERT_TRUE(std::abs(point.position.y()) <= 70.0);
    sum += point.position;
  }
  EXPECT_NEAR(sum.x() / 1e4, 70.0, mean_tolerance(140.0 / std::sqrt(12.0), 1e4));
  EXPECT_NEAR(sum.y() / 1e4, 0.0, mean_tolerance(140.0 / std::sqrt(12.0), 1e4));
}

}  // namespace
}  // namespace lookout::sonar_sim
