#include "fusion/methods/covariance_fusion.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/filter_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::fuse;
using testing::with_covariance;

TEST(CovarianceFusion, SumOfInformationByHand) {
  CovarianceFusion method(CovarianceWeights::sum, 0.0);
  const auto fused =
      fuse(method, {with_covariance(1, {0, 0, 1, 0}, 1.0, 4.0), with_covariance(2, {4, 4, 1, 0}, 4.0, 1.0)});
  // 4 / (1 + 4) and 4 * 4 / 5 from the inverse variances 1 and 1/4.
  EXPECT_NEAR(fused.state.x(), 0.8, 1e-12);
  EXPECT_NEAR(fused.state.y(), 3.2, 1e-12);
  EXPECT_NEAR(fused.covariance(0, 0), 0.8, 1e-12);
}

TEST(CovarianceFusion, IntersectionOfEqualSensorsClaimsNoGain) {
  CovarianceFusion method(CovarianceWeights::intersection, 0.0);
  const auto fused =
      fuse(method, {with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0), with_covariance(2, {4, 4, 1, 0}, 2.0, 2.0)});
  EXPECT_NEAR(fused.state.x(), 2.0, 1e-12);
  EXPECT_NEAR(fused.covariance(0, 0), 2.0, 1e-12);  // P^-1 = 0.5 P^-1 + 0.5 P^-1.
}

TEST(CovarianceFusion, LeastTraceIsThatOfASearch) {
  // Ellipses at right angles; by symmetry but for the 1.5 the weights are near a half.
  const std::vector<LocalTrack> tracks{with_covariance(1, {0, 0, 1, 0}, 1.0, 900.0),
                                       with_covariance(2, {4, 4, 1, 0}, 900.0, 1.5)};
  double least = 1e9;
  for (int k = 1; k < 2000; ++k) {
    const double w = k / 2000.0;
    const Eigen::Vector4d information = w * Eigen::Vector4d(1.0, 1.0 / 900.0, 1, 1) +
                                        (1.0 - w) * Eigen::Vector4d(1.0 / 900.0, 1.0 / 1.5, 1, 1);
    least = std::min(least, information.cwiseInverse().sum());
  }
  CovarianceFusion best(CovarianceWeights::least_trace, 0.0), closed(CovarianceWeights::intersection, 0.0);
  EXPECT_NEAR(fuse(best, tracks).covariance.trace(), least, 1e-3 * least);
  EXPECT_LE(fuse(best, tracks).covariance.trace(), fuse(closed, tracks).covariance.trace() + 1e-9);
}

TEST(CovarianceFusion, LeastTraceLeavesOutANodeThatTellsNothing) {
  CovarianceFusion method(CovarianceWeights::least_trace, 0.0);
  const auto fused = fuse(
      method, {with_covariance(1, {0, 0, 1, 0}, 1.0, 1.0), with_covariance(2, {9, 9, 1, 0}, 99.0, 99.0)});
  EXPECT_NEAR(fused.covariance(0, 0), 1.0, 0.02);
  EXPECT_NEAR(fused.state.x(), 0.0, 0.1);
}

TEST(CovarianceFusion, AnOldEstimateIsLessCertain) {
  const LocalTrack track = with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0);
  // P + t^2 (velocity variance 1) + q t^3 / 3 after t = 2 s with q = 3.
  EXPECT_NEAR(covariance_at(track, core::microseconds(3.0), 3.0)(0, 0), 2.0 + 4.0 + 8.0, 1e-12);
}

TEST(CovarianceFusion, RefusesABadParameter) {
  EXPECT_THROW(CovarianceFusion(CovarianceWeights::sum, -0.1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
