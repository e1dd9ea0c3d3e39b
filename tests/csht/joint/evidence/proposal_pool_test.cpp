#include "csht/joint/evidence/proposal_pool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

// The covariance of a standard t draw is freedom / (freedom - 2): 1.5 for 6 degrees of freedom.
TEST(ProposalPool, DrawsHaveMeanZeroAndTheVarianceOfTheTDistribution) {
  core::Random random(1);
  const ProposalPool pool(6.0, 16384, random);
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    mean += pool.at(0, i).z[2] / static_cast<double>(pool.size());
    square += pool.at(0, i).z[2] * pool.at(0, i).z[2] / static_cast<double>(pool.size());
  }
  EXPECT_NEAR(mean, 0.0, 0.04);  // Four standard errors, sqrt(1.5 / 16384).
  EXPECT_NEAR(square, 1.5, 0.15);
}

// Importance sampling of a standard Gaussian has the integral 1 when the densities are right.
TEST(ProposalPool, DensitiesIntegrateTheGaussianToOne) {
  core::Random random(2);
  const ProposalPool pool(6.0, 16384, random);
  double four = 0.0, five = 0.0, six = 0.0;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    const auto& draw = pool.at(0, i);
    double square = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      square += draw.z[k] * draw.z[k];
      const double log_gaussian =
          -0.5 * square - 0.5 * static_cast<double>(k + 1) * std::log(2.0 * std::numbers::pi);
      if (k == 3)
        four += std::exp(log_gaussian - pool.log_density(draw, 4)) / static_cast<double>(pool.size());
      if (k == 4)
        five += std::exp(log_gaussian - pool.log_density(draw, 5)) / static_cast<double>(pool.size());
      if (k == 5)
        six += std::exp(log_gaussian - pool.log_density(draw, 6)) / static_cast<double>(pool.size());
    }
  }
  EXPECT_NEAR(four, 1.0, 0.03);
  EXPECT_NEAR(five, 1.0, 0.03);
  EXPECT_NEAR(six, 1.0, 0.03);
}

TEST(ProposalPool, WrapsAround) {
  core::Random random(3);
  const ProposalPool pool(6.0, 64, random);
  EXPECT_EQ(&pool.at(60, 10), &pool.at(6, 0));
}

}  // namespace
}  // namespace lookout::csht
