#include "sonar_sim/image/speckle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/beam_bearings.hpp"

namespace lookout::sonar_sim {
namespace {

/// An image of `beams` x `bins` cells, bins of 10 cm.
core::SonarImage image_of(int beams, int bins, double bearing_step) {
  core::SonarImage image;
  image.bearings = core::even_bearings(0.0, bearing_step, beams);
  image.first_range = 0.05;
  image.range_step = 0.1;
  image.num_bins = bins;
  image.intensity.assign(static_cast<std::size_t>(beams) * static_cast<std::size_t>(bins), 0.0);
  return image;
}

/// A Rayleigh background through a pulse of 20 cm and a beam of one degree to its null.
ImagePlan correlated_plan() {
  ImagePlan plan;
  plan.shape.reset();
  plan.pulse_sigma = 0.2;
  plan.beam_null = core::radians(1.0);
  plan.sea.correlated_speckle = true;
  return plan;
}

/// Mean of x conj(y) over pairs of cells that are `beams` and `bins` apart.
double correlation(const core::SonarImage& image, const std::vector<std::complex<double>>& field, int beams,
                   int bins) {
  std::complex<double> sum = 0.0;
  int pairs = 0;
  for (int beam = 0; beam + beams < image.num_beams(); ++beam)
    for (int bin = 0; bin + bins < image.num_bins; ++bin, ++pairs)
      sum += field[static_cast<std::size_t>(beam * image.num_bins + bin)] *
             std::conj(field[static_cast<std::size_t>((beam + beams) * image.num_bins + bin + bins)]);
  return sum.real() / pairs;
}

TEST(Speckle, HasTheMomentsOfItsLaw) {
  // E|x|^4 / (E|x|^2)^2 is 2 of Rayleigh amplitudes and 2 (1 + 1 / nu) of K-distributed ones.
  const auto image = image_of(400, 500, 0.01);
  for (const std::optional<double> shape : {std::optional<double>(), std::optional(4.0)}) {
    ImagePlan plan;
    plan.shape = shape;
    core::Random random(1000);
    double second = 0.0, fourth = 0.0;
    const auto field = draw_speckle(image, plan, random);
    for (const auto& x : field) second += std::norm(x), fourth += std::norm(x) * std::norm(x);
    const auto n = static_cast<double>(field.size());
    EXPECT_NEAR(second / n, 1.0, 0.01);
    EXPECT_NEAR(fourth / n / (second / n * second / n), shape ? 2.5 : 2.0, 0.06);
  }
}

TEST(Speckle, OfNoCorrelationIsIndependentFromCellToCell) {
  ImagePlan plan = correlated_plan();
  plan.sea.correlated_speckle = false;
  const auto image = image_of(200, 1000, 0.01);
  core::Random random(1001);
  const auto field = draw_speckle(image, plan, random);
  // 200,000 pairs: a standard deviation of .0016.
  EXPECT_NEAR(correlation(image, field, 0, 1), 0.0, 0.008);
  EXPECT_NEAR(correlation(image, field, 1, 0), 0.0, 0.008);
}

TEST(Speckle, CorrelatesAsThePulseInRange) {
  const ImagePlan plan = correlated_plan();
  const auto image = image_of(200, 1000, 0.1);  // Beams far apart.
  core::Random random(1002);
  const auto field = draw_speckle(image, plan, random);
  EXPECT_NEAR(correlation(image, field, 0, 0), 1.0, 0.02);
  for (const int bins : {1, 2, 4}) {
    const double x = 0.1 * bins / 0.2;
    // White noise through a Gaussian of sigma has the correlation exp(-d^2 / (4 sigma^2)).
    EXPECT_NEAR(correlation(image, field, 0, bins), std::exp(-x * x / 4.0), 0.02) << bins;
  }
  EXPECT_NEAR(correlation(image, field, 1, 0), 0.0, 0.02);
}

TEST(Speckle, CorrelatesAsTheBeamPatternInBearing) {
  ImagePlan plan = correlated_plan();
  plan.pulse_sigma = 0.01;  // Bins are independent.
  const auto image = image_of(400, 500, core::radians(0.25));
  core::Random random(1003);
  const auto field = draw_speckle(image, plan, random);
  EXPECT_NEAR(correlation(image, field, 0, 0), 1.0, 0.02);
  // sinc convolved with itself is sinc; cutting it at four nulls changes the third digit.
  for (const int beams : {1, 2, 4}) {
    const double x = 3.14159265358979 * 0.25 * beams;
    EXPECT_NEAR(correlation(image, field, beams, 0), std::sin(x) / x, 0.03) << beams;
  }
}

TEST(Speckle, OfUnevenBeamsKeepsItsPower) {
  auto image = image_of(300, 300, 0.01);
  for (std::size_t beam = 0; beam < image.bearings.size(); ++beam)
    image.bearings[beam] = 0.002 * static_cast<double>(beam) + 1e-5 * static_cast<double>(beam * beam);
  core::Random random(1004);
  const auto field = draw_speckle(image, correlated_plan(), random);
  EXPECT_NEAR(correlation(image, field, 0, 0), 1.0, 0.03);
}

}  // namespace
}  // namespace lookout::sonar_sim
