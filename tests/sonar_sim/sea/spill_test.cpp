#include "sonar_sim/sea/spill.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

const Spill kSpill{{0.7, 0.3}, 1.0, {6.0}, false};

TEST(Spill, EachSideAndOffsetByItsProbability) {
  const Ping ping = ping_at_origin();
  core::Random random(1);
  std::map<int, int> count;
  for (int k = 0; k < kPings; ++k)
    for (const auto& one : draw_spill(kSpill, ping, {echo_in(ping, 45, 60.0)}, random)) ++count[one.beam];
  ASSERT_EQ(count.size(), 4u);  // beams 43, 44, 46, 47
  for (const auto& [beam, expected] : std::map<int, double>{{43, 0.3}, {44, 0.7}, {46, 0.7}, {47, 0.3}})
    EXPECT_NEAR(count[beam] / static_cast<double>(kPings), expected, rate_tolerance(expected, kPings))
        << beam;
}

TEST(Spill, RangesScatterAboutTheEchoAndBearingsAreTheBeams) {
  const Ping ping = ping_at_origin();
  core::Random random(2);
  double sum = 0.0, squares = 0.0, number = 0.0;
  for (int k = 0; k < kPings; ++k)
    for (const auto& one : draw_spill(kSpill, ping, {echo_in(ping, 45, 60.0)}, random)) {
      ASSERT_DOUBLE_EQ(one.measured.bearing, ping.params.beam_centre(one.beam));
      sum += one.measured.range - 60.0;
      squares += (one.measured.range - 60.0) * (one.measured.range - 60.0);
      ++number;
    }
  EXPECT_NEAR(sum / number, 0.0, mean_tolerance(1.0, number));
  EXPECT_NEAR(squares / number, 1.0, variance_tolerance(1.0, number));
}

TEST(Spill, StopsAtTheEdgeOfTheFanAndGoesRoundAWholeCircle) {
  const Spill certain{{1.0}, 0.0, {}, false};
  core::Random random(3);
  Ping ping = ping_at_origin();
  EXPECT_EQ(draw_spill(certain, ping, {echo_in(ping, 0, 60.0)}, random).size(), 1u);
  ping.params.bearing_step = core::radians(4.0);
  const auto repeated = draw_spill(certain, ping, {echo_in(ping, 0, 60.0)}, random);
  ASSERT_EQ(repeated.size(), 2u);
  EXPECT_EQ(repeated[0].beam, 89);
}

TEST(Spill, WeakensTheRepeatedEchoAndLeavesStandingThingsAlone) {
  const Ping ping = ping_at_origin();
  core::Random random(4);
  BeamReturn rock = echo_in(ping, 20, 30.0);
  rock.source = Source::standing;
  const auto repeated =
      draw_spill({{1.0, 1.0}, 0.0, {6.0}, false}, ping, {echo_in(ping, 45, 60.0), rock}, random);
  ASSERT_EQ(repeated.size(), 4u);
  for (const auto& one : repeated) EXPECT_EQ(one.loss_db, std::abs(one.beam - 45) == 1 ? 6.0 : 0.0);
  EXPECT_EQ(draw_spill({{1.0}, 0.0, {}, true}, ping, {rock}, random).size(), 2u);
}

// Of uneven beams the neighbour is the next beam, wherever it points.
TEST(Spill, GoesOverTheBeamsOfAnUnevenFan) {
  Ping ping = ping_at_origin();
  const std::vector<double> centres{-0.3, -0.1, 0.0, 0.05, 0.4};
  ping.params.fan = std::make_shared<const core::UnevenFan>(centres);
  ping.params.num_beams = 5;
  core::Random random(1000);
  Spill spill;
  spill.probabilities = {1.0};
  const std::vector<BeamReturn> heard{{2, {0.0, 50.0, 1.0}, Source::target}};
  const auto repeated = draw_spill(spill, ping, heard, random);
  ASSERT_EQ(repeated.size(), 2u);
  for (const auto& one : repeated)
    EXPECT_DOUBLE_EQ(one.measured.bearing, centres[static_cast<std::size_t>(one.beam)]);
}

}  // namespace
}  // namespace lookout::sonar_sim
