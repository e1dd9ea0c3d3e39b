#include "sonar_sim/image/gain_stripes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::sonar_sim {
namespace {

TEST(GainStripes, AreUniformInDecibels) {
  core::Random random(1000);
  const auto gains = draw_gains({10.0, 1}, 20'000, random);
  double sum = 0.0, squares = 0.0, largest = 0.0;
  for (const double gain : gains) {
    const double db = 20.0 * std::log10(gain);
    sum += db, squares += db * db, largest = std::max(largest, std::abs(db));
  }
  EXPECT_LE(largest, 5.0);
  EXPECT_NEAR(sum / 20'000, 0.0, 0.1);
  EXPECT_NEAR(squares / 20'000, 100.0 / 12.0, 0.3);  // Of a uniform law 10 wide.
}

TEST(GainStripes, HoldOverTheirWidth) {
  core::Random random(1001);
  const auto gains = draw_gains({10.0, 4}, 10, random);
  ASSERT_EQ(gains.size(), 10u);
  EXPECT_EQ(gains[0], gains[3]);
  EXPECT_NE(gains[3], gains[4]);
  EXPECT_EQ(gains[8], gains[9]);
}

}  // namespace
}  // namespace lookout::sonar_sim
