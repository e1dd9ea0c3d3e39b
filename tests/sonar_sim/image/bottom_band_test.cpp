#include "sonar_sim/image/bottom_band.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::sonar_sim {
namespace {

TEST(BottomBand, BeginsAtItsRangeAndFallsBehindIt) {
  const ImagePlan plan;
  const BottomBand bottom{40.0, 0.0, 1.0, 20.0, 10.0};
  EXPECT_EQ(bottom_amplitude(bottom, plan, 3, 90, 39.9), 0.0);
  const double begin = bottom_amplitude(bottom, plan, 3, 90, 40.0);
  EXPECT_NEAR(begin, 10.0 * plan.background_level(40.0), 1e-9);  // 20 dB of amplitude
  EXPECT_NEAR(bottom_amplitude(bottom, plan, 3, 90, 50.0), begin / std::exp(1.0), 1e-9);
}

TEST(BottomBand, WavesOverTheBeams) {
  const ImagePlan plan;
  const BottomBand bottom{40.0, 5.0, 1.0, 20.0, 10.0};
  EXPECT_EQ(bottom_amplitude(bottom, plan, 25, 100, 44.9), 0.0);  // A quarter of a cycle: at 45 m.
  EXPECT_GT(bottom_amplitude(bottom, plan, 75, 100, 35.1), 0.0);  // Three quarters: at 35 m.
}

}  // namespace
}  // namespace lookout::sonar_sim
