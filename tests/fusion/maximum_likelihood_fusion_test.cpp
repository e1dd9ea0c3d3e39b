#include "fusion/maximum_likelihood_fusion.hpp"

#include <gtest/gtest.h>

#include "fusion/covariance_fusion.hpp"
#include "tests/fusion/filter_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::fuse;
using testing::with_covariance;

TEST(MaximumLikelihoodFusion, OfOneNodeIsThatNode) {
  MaximumLikelihoodFusion method({});
  const auto fused = fuse(method, {with_covariance(1, {3, 4, 1, 0}, 2.0, 5.0)});
  EXPECT_NEAR((fused.state - Eigen::Vector4d(3, 4, 1, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(fused.covariance(1, 1), 5.0, 1e-9);
}

TEST(MaximumLikelihoodFusion, IsBetweenTheSingleNodeAndTheSumThatForgetsTheCrossTerms) {
  const std::vector<LocalTrack> tracks{with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0),
                                       with_covariance(2, {1, 1, 1, 0}, 2.0, 2.0)};
  MaximumLikelihoodFusion method({0.5, 3.0});
  CovarianceFusion sum(CovarianceWeights::sum, 0.5);
  const double variance = fuse(method, tracks).covariance(0, 0);
  EXPECT_LT(variance, 2.0);
  EXPECT_GT(variance, fuse(sum, tracks).covariance(0, 0));  // The shared process noise is not halved.
}

TEST(MaximumLikelihoodFusion, RefusesABadParameter) {
  EXPECT_THROW(MaximumLikelihoodFusion({-1.0, 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
