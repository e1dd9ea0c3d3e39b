#include "tools/watch/rate_meter.hpp"

#include <gtest/gtest.h>

#include "tests/tools/watch/watch_examples.hpp"

namespace lookout::tools {
namespace {

TEST(RateMeter, IsTheReciprocalOfTheMeanGapAndSinksInSilence) {
  RateMeter meter;
  EXPECT_FALSE(meter.age(at_second(0.0)));
  for (int k = 0; k < 500; ++k) meter.add(at_second(0.05 * k));
  EXPECT_NEAR(meter.rate(at_second(0.05 * 499)), 20.0, 1e-6);  // 1 / 0.05 s.
  EXPECT_NEAR(meter.mean_gap(), 0.05, 1e-9);
  EXPECT_NEAR(*meter.age(at_second(0.05 * 499 + 2.0)), 2.0, 1e-9);
  EXPECT_LT(meter.rate(at_second(0.05 * 499 + 30.0)), 0.2);
}

TEST(RateMeter, ForgetsWhatIsOldButTheNewest) {
  RateMeter meter;
  meter.add(at_second(0.0));
  meter.add(at_second(40.0));
  EXPECT_EQ(meter.rate(at_second(40.0)), 0.0);
  EXPECT_EQ(*meter.age(at_second(41.0)), 1.0);
}

}  // namespace
}  // namespace lookout::tools
