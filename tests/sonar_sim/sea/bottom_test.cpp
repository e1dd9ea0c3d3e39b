#include "sonar_sim/sea/bottom.hpp"

#include <gtest/gtest.h>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

TEST(Bottom, RangeFollowsTheWave) {
  const Bottom bottom{110.0, 5.0, 1.0, 4.0, 0.6};
  EXPECT_DOUBLE_EQ(bottom_range(bottom, 0, 100), 110.0);
  EXPECT_DOUBLE_EQ(bottom_range(bottom, 25, 100), 115.0);  // a quarter of a cycle
  EXPECT_DOUBLE_EQ(bottom_range(bottom, 75, 100), 105.0);
}

TEST(Bottom, EachBeamReturnsWithItsProbabilityAndNoise) {
  const Ping ping = ping_at_origin();
  const Bottom bottom{110.0, 5.0, 1.0, 4.0, 0.6};
  core::Random random(1);
  double number = 0.0, squares = 0.0;
  constexpr int kScans = 1000;
  for (int k = 0; k < kScans; ++k)
    for (const auto& one : draw_bottom(bottom, ping, random)) {
      squares += std::pow(one.measured.range - bottom_range(bottom, one.beam, 90), 2);
      ++number;
    }
  EXPECT_NEAR(number / (kScans * 90.0), 0.6, rate_tolerance(0.6, kScans * 90.0));
  EXPECT_NEAR(squares / number, 16.0, variance_tolerance(4.0, number));
}

TEST(Bottom, BeyondTheRangeIsNotHeard) {
  Ping ping = ping_at_origin();
  ping.params.max_range = 75.0;
  core::Random random(2);
  EXPECT_TRUE(draw_bottom({110.0, 5.0, 1.0, 1.0, 1.0}, ping, random).empty());
}

}  // namespace
}  // namespace lookout::sonar_sim
