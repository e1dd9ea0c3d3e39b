#include "sonar_sim/sea/heavy_tails.hpp"

#include <gtest/gtest.h>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

/// The share of errors beyond `limit` standard deviations sigma of the Gaussian.
double share_beyond(double degrees_of_freedom, double limit) {
  core::Random gaussian(1), chi_square(2);
  int beyond = 0;
  for (int k = 0; k < kPings; ++k) {
    std::vector<BeamTarget> targets{{45, 60.0, 0.0}};
    widen({degrees_of_freedom}, targets, chi_square);
    beyond += std::abs(targets[0].noise_scale * gaussian.gaussian()) > limit ? 1 : 0;
  }
  return static_cast<double>(beyond) / kPings;
}

TEST(HeavyTails, AreThoseOfStudentsT) {
  // P(|t| > x), two-sided critical values of tables of Student's t: 3 degrees of freedom 3.182 and 5.841,
  // 1 degree (Cauchy) 12.706.
  EXPECT_NEAR(share_beyond(3.0, 3.182), 0.05, rate_tolerance(0.05, kPings));
  EXPECT_NEAR(share_beyond(3.0, 5.841), 0.01, rate_tolerance(0.01, kPings));
  EXPECT_NEAR(share_beyond(1.0, 12.706), 0.05, rate_tolerance(0.05, kPings));
}

}  // namespace
}  // namespace lookout::sonar_sim
