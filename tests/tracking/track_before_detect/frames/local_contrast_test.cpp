#include "tracking/track_before_detect/frames/local_contrast.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr int kColumns = 80;
constexpr int kRows = 60;

std::vector<double> noise(std::uint64_t seed) {
  core::Random random(seed);
  std::vector<double> grey;
  for (int i = 0; i < kColumns * kRows; ++i) grey.push_back(100.0 + random.gaussian(3.0));
  return grey;
}

double& at(std::vector<double>& grey, int x, int y) {
  return grey[static_cast<std::size_t>(y * kColumns + x)];
}

TEST(LocalContrast, ASpotStandsOut) {
  std::vector<double> grey = noise(1000);
  for (int x = 40; x < 42; ++x)
    for (int y = 30; y < 32; ++y) at(grey, x, y) += 40.0;
  std::vector<double> contrast = local_contrast(grey, kColumns, kRows);
  const double spot = at(contrast, 40, 30);
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x)
      if (std::abs(x - 40) > 3 || std::abs(y - 30) > 3) {
        EXPECT_LT(at(contrast, x, y), 0.5 * spot) << x << " " << y;
      }
}

TEST(LocalContrast, EdgesAndStripesDoNot) {
  std::vector<double> grey = noise(1001);
  for (int x = 0; x < kColumns; ++x)
    for (int y = 0; y < kRows; ++y) {
      if (x > 50) at(grey, x, y) += 80.0;
      if (y == 20 || y == 21) at(grey, x, y) = 0.0;
      if (y == 40) at(grey, x, y) += 60.0;
    }
  std::vector<double> contrast = local_contrast(grey, kColumns, kRows);
  for (const int x : {20, 51, 60})
    for (const int y : {22, 30, 40}) EXPECT_LT(at(contrast, x, y), 1.5) << x << " " << y;
}

TEST(LocalContrast, DoesNotDependOnTheLevel) {
  std::vector<double> grey = noise(1002), raised = grey;
  for (double& value : raised) value += 50.0;
  const auto a = local_contrast(grey, kColumns, kRows), b = local_contrast(raised, kColumns, kRows);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-6);
}

}  // namespace
}  // namespace lookout::tracking
