#include "csht/likelihood/fast_math.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

// The bounds are those of the truncated series and of [Abramowitz1964] 4.4.49, plus single rounding.
TEST(FastMath, ExpIsWithinItsBound) {
  for (float x = -79.9F; x < 80.0F; x += 0.0137F) EXPECT_NEAR(fast_exp(x) / std::exp(x), 1.0, 1e-5) << x;
  EXPECT_GT(fast_exp(-1e9F), 0.0F);
  EXPECT_LT(fast_exp(-1e9F), 1e-34F);
}

TEST(FastMath, LogIsWithinItsBound) {
  for (float x = 1e-30F; x < 1e30F; x *= 1.0173F)
    EXPECT_NEAR(fast_log(x), std::log(x), 3e-7F * std::max(1.0F, std::abs(std::log(x)))) << x;
}

TEST(FastMath, NormalTailIsWithinItsBound) {
  for (float x = -9.0F; x < 9.0F; x += 0.0137F)
    EXPECT_NEAR(fast_normal_tail(x), 0.5 * std::erfc(static_cast<double>(x) / std::sqrt(2.0)), 1e-6) << x;
}

TEST(FastMath, AtanCoversTheCircle) {
  for (float angle = -3.14F; angle < 3.14F; angle += 0.0101F)
    EXPECT_NEAR(fast_atan2(7.0F * std::sin(angle), 7.0F * std::cos(angle)), angle, 1e-6F);
  EXPECT_EQ(fast_atan2(0.0F, 0.0F), 0.0F);
}

TEST(FastMath, SineAndCosineAreWithinTheirBound) {
  for (double angle = -100.0; angle < 100.0; angle += 0.00731) {
    EXPECT_NEAR(fast_sin_cos(angle).sin, std::sin(angle), 1e-9) << angle;
    EXPECT_NEAR(fast_sin_cos(angle).cos, std::cos(angle), 1e-9) << angle;
  }
}

}  // namespace
}  // namespace lookout::csht
