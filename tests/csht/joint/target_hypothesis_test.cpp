#include "csht/joint/target_hypothesis.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

TEST(TargetHypothesis, AdvancesAlongItsVelocity) {
  TargetHypothesis target;
  target.mean = {10.0, 20.0, 1.0, -2.0};
  target.samples[0] = target.mean;
  advance(2.0, target);
  EXPECT_EQ(target.mean, Eigen::Vector4d(12.0, 16.0, 1.0, -2.0));
  EXPECT_EQ(target.samples[0], target.mean);
  // With unit variances: position variance 1 + t^2, covariance of position and velocity t.
  EXPECT_DOUBLE_EQ(target.covariance(0, 0), 5.0);
  EXPECT_DOUBLE_EQ(target.covariance(0, 2), 2.0);
}

TEST(TargetHypothesis, ExistenceIsTheLogisticOfItsOdds) {
  TargetHypothesis target;
  target.log_odds = 0.0;
  EXPECT_DOUBLE_EQ(target.existence(), 0.5);
  target.log_odds = std::log(3.0);
  EXPECT_DOUBLE_EQ(target.existence(), 0.75);
}

}  // namespace
}  // namespace lookout::csht
