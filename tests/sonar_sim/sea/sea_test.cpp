#include "sonar_sim/sea/sea.hpp"

#include <gtest/gtest.h>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

std::size_t count_of(const std::vector<BeamReturn>& heard, Source source) {
  std::size_t count = 0;
  for (const auto& one : heard) count += one.source == source ? 1 : 0;
  return count;
}

SeaPlan certain_sea() {
  SeaPlan plan;
  plan.spill = Spill{{1.0}, 0.0, {}, true};
  plan.standing.points = {{{60.0, 0.5}, {1.0, 0.0, std::nullopt}}};
  plan.bottom = Bottom{110.0, 0.0, 1.0, 0.0, 1.0};
  return plan;
}

TEST(Sea, ByDefaultAddsNothing) {
  Sea sea({}, {1, 0, 0, 0});
  const Ping ping = ping_at_origin();
  std::vector<BeamReturn> heard{echo_in(ping, 45, 60.0)};
  sea.add_returns(ping, heard);
  sea.mark(heard);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].measured.intensity, 1.0);
  EXPECT_EQ(sea.draw_fate(), ScanFate::whole);
}

TEST(Sea, AddsEveryPartOfThePlan) {
  Sea sea(certain_sea(), {1, 0, 0, 0});
  const Ping ping = ping_at_origin();
  std::vector<BeamReturn> heard{echo_in(ping, 20, 60.0)};
  sea.add_returns(ping, heard);
  EXPECT_EQ(count_of(heard, Source::standing), 1u);
  EXPECT_EQ(count_of(heard, Source::spill), 4u);  // both sides of the echo and of the point
  EXPECT_EQ(count_of(heard, Source::clutter), 90u);
}

TEST(Sea, SwitchingOnePartOnLeavesTheDrawsOfTheOthers) {
  SeaPlan alone;
  alone.bottom = Bottom{};
  SeaPlan both = alone;
  both.standing.points = {{{60.0, 0.5}, {}}};
  Sea first(alone, {1, 0, 0, 0}), second(both, {1, 0, 0, 0});
  const Ping ping = ping_at_origin();
  for (int k = 0; k < 20; ++k) {
    std::vector<BeamReturn> a, b;
    first.add_returns(ping, a);
    second.add_returns(ping, b);
    ASSERT_EQ(count_of(a, Source::clutter), count_of(b, Source::clutter));
    EXPECT_EQ(a.back().measured.range, b.back().measured.range);
  }
}

TEST(Sea, AFieldStandsWhereItStandsForEverySonarOfARun) {
  SeaPlan plan;
  plan.standing.fields = {{5, {40.0, -10.0}, {80.0, 10.0}, {1.0, 0.0, std::nullopt}}};
  Sea one(plan, {1, 0, 0, 0}), other_sonar(plan, {1, 0, 1, 1}), other_run(plan, {1, 1, 0, 0});
  const Ping ping = ping_at_origin();
  std::vector<BeamReturn> a, b, c;
  one.add_returns(ping, a);
  other_sonar.add_returns(ping, b);
  other_run.add_returns(ping, c);
  ASSERT_EQ(a.size(), 5u);
  ASSERT_EQ(b.size(), 5u);
  ASSERT_EQ(c.size(), 5u);
  EXPECT_EQ(a[0].measured.range, b[0].measured.range);
  EXPECT_NE(a[0].measured.range, c[0].measured.range);
}

}  // namespace
}  // namespace lookout::sonar_sim
