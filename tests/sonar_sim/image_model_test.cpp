#include "sonar_sim/image_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lookout::sonar_sim {
namespace {

using Field = std::vector<std::complex<double>>;

TEST(ImageModel, TheBeamPatternIsOneOnAxisAndZeroAtItsNull) {
  const ImagePlan plan;
  EXPECT_DOUBLE_EQ(beam_response(plan, 0.0), 1.0);
  EXPECT_NEAR(beam_response(plan, plan.beam_null), 0.0, 1e-12);
  EXPECT_NEAR(beam_response(plan, 0.5 * plan.beam_null), 2.0 / M_PI, 1e-12);  // sinc(1/2)
}

TEST(ImageModel, ThePulseFallsToItsShareAtOneSigma) {
  const ImagePlan plan;
  EXPECT_NEAR(pulse_response(plan, plan.pulse_sigma), std::exp(-0.5), 1e-12);
}

TEST(ImageModel, ATaperKeepsTheNullAndLowersTheSideLobes) {
  ImagePlan plan;
  plan.beam_null = 1.0;
  const auto side_lobe_db = [&plan] {
    double largest = 0.0;
    for (int k = 101; k < 400; ++k) largest = std::max(largest, std::abs(beam_response(plan, 0.01 * k)));
    return 20.0 * std::log10(largest);
  };
  EXPECT_NEAR(side_lobe_db(), -13.26, 0.05);  // Of a uniform aperture,
  plan.tapered = true;
  EXPECT_NEAR(side_lobe_db(), -31.47, 0.05);  // and of a Hann taper.
  EXPECT_NEAR(beam_response(plan, 1.0), 0.0, 1e-12);
  EXPECT_NEAR(beam_response(plan, 0.5), 0.5, 1e-12);  // The limit at the pole.
  EXPECT_EQ(beam_response(plan, 0.0), 1.0);
}

TEST(ImageModel, AnEchoPeaksInItsCellAtItsRatio) {
  const core::SonarParams sonar;
  const ImagePlan plan;
  const core::SonarImage image = empty_image(sonar, plan);
  ASSERT_EQ(image.intensity.size(), 27000u);
  Field field(image.intensity.size());
  const double range = plan.first_range + 120 * plan.range_step;
  add_echo(image, plan, {range, sonar.beam_centre(30), 20.0, 1.0}, field);
  const double peak = std::abs(field[30 * 300 + 120]);
  EXPECT_NEAR(peak / plan.background_level(range), 10.0, 1e-9);  // 20 dB of amplitude
  for (const auto& cell : field) EXPECT_LE(std::abs(cell), peak + 1e-12);
}

TEST(ImageModel, AnEchoBeyondTheLastBinLeavesTheImageDark) {
  const ImagePlan plan;
  const core::SonarImage image = empty_image({}, plan);
  Field field(image.intensity.size());
  add_echo(image, plan, {200.0, 0.0, 20.0, 0.0}, field);
  for (const auto& cell : field) EXPECT_EQ(std::abs(cell), 0.0);
}

TEST(ImageModel, RefusesValuesOutOfRange) {
  ImagePlan plan;
  plan.shape = 0.0;
  EXPECT_THROW(check(plan), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::sonar_sim
