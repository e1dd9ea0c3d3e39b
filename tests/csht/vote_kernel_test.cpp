#include "csht/vote_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace lookout::csht {
namespace {

TEST(VoteKernel, PlainVoteIsOneWholeVoteInTheCellOfTheIntercept) {
  const VoteKernel kernel = VoteKernel::plain();
  for (int phase = 0; phase < VoteKernel::kPhases; ++phase) {
    const Footprint footprint = kernel.at(0, phase);
    EXPECT_EQ(footprint.first, 0);
    EXPECT_EQ(footprint.values[0], kVoteUnit);
    EXPECT_EQ(std::accumulate(footprint.values.begin(), footprint.values.end(), 0), kVoteUnit);
  }
}

// A Gaussian of width w sampled once a cell sums to w sqrt(2 pi), a cut at three widths losing 0.3 %.
TEST(VoteKernel, GaussianVotesSumToTheirArea) {
  const VoteKernel kernel = VoteKernel::gaussian(2.0, 2.0);
  for (int phase = 0; phase < VoteKernel::kPhases; ++phase) {
    const Footprint footprint = kernel.at(0, phase);
    const double sum = std::accumulate(footprint.values.begin(), footprint.values.end(), 0.0) / kVoteUnit;
    EXPECT_NEAR(sum, 2.0 * std::sqrt(2.0 * std::acos(-1.0)), 0.05);
  }
}

TEST(VoteKernel, GaussianPeaksAtTheInterceptAndFallsAsAGaussian) {
  const VoteKernel kernel = VoteKernel::gaussian(2.0, 2.0);
  const int phase = VoteKernel::kPhases / 2;  // the intercept within 1/32 of the middle of its cell
  const Footprint footprint = kernel.at(0, phase);
  const auto at = [&](int cell) {
    return footprint.values[static_cast<std::size_t>(cell - footprint.first)];
  };
  EXPECT_NEAR(at(0), kVoteUnit, 1);
  EXPECT_NEAR(at(2), kVoteUnit * std::exp(-0.5), 3.0);   // one width away
  EXPECT_NEAR(at(-4), kVoteUnit * std::exp(-2.0), 3.0);  // two widths away
}

TEST(VoteKernel, FootprintsFillWholeVectorsAndWidthsAreFound) {
  const VoteKernel kernel = VoteKernel::gaussian(0.7, 4.0);
  EXPECT_EQ(kernel.width_index(0.1), 0);
  const int widest = kernel.width_index(100.0);
  EXPECT_GT(kernel.at(widest, 0).values.size(), kernel.at(0, 0).values.size());
  EXPECT_EQ(kernel.at(widest, 0).values.size() % VoteKernel::kLanes, 0U);
  EXPECT_THROW(VoteKernel::gaussian(0.0, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
