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
