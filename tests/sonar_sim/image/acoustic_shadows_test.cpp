#include "sonar_sim/image/acoustic_shadows.hpp"

#include <gtest/gtest.h>

#include "core/beam_bearings.hpp"

namespace lookout::sonar_sim {
namespace {

core::SonarImage fan() {
  core::SonarImage image;
  image.bearings = core::even_bearings(core::radians(-2.0), core::radians(1.0), 5);
  image.first_range = 0.5;
  image.range_step = 1.0;
  image.num_bins = 100;
  return image;
}

std::vector<double> shaded(const std::vector<StandingScatterer>& scatterers) {
  ImagePlan plan;
  plan.beam_null = core::radians(2.5);  // Half of it: the beam of the thing, and one on either side.
  plan.pulse_sigma = 0.5;
  std::vector<double> levels(500, 1.0);
  cast_shadows({20.0, 10.0}, plan, fan(), scatterers, levels);
  return levels;
}

TEST(AcousticShadows, LieBehindAPointForTheirLength) {
  const auto levels = shaded({{30.0, 0.0, 10.0, false}});
  const auto at = [&levels](int beam, int bin) { return levels[static_cast<std::size_t>(beam * 100 + bin)]; };
  EXPECT_EQ(at(2, 30), 1.0);           // 30.5 m: within the pulse of the echo.
  EXPECT_NEAR(at(2, 31), 0.1, 1e-12);  // 20 dB of amplitude from 31 m on,
  EXPECT_NEAR(at(2, 40), 0.1, 1e-12);
  EXPECT_EQ(at(2, 41), 1.0);  // to 41 m.
  EXPECT_NEAR(at(1, 35), 0.1, 1e-12);
  EXPECT_EQ(at(0, 35), 1.0);
}

TEST(AcousticShadows, OfAWallReachToTheEndAndDoNotAddUp) {
  const auto levels = shaded({{30.0, 0.0, 10.0, true}, {35.0, 0.0, 10.0, false}});
  EXPECT_NEAR(levels[2 * 100 + 99], 0.1, 1e-12);
  EXPECT_NEAR(levels[2 * 100 + 40], 0.1, 1e-12);
}

}  // namespace
}  // namespace lookout::sonar_sim
