#include "tracking/baselines/gaussian/target_mixture.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(ModeSum, KeepsMeanAndCovariance) {
  GaussianMode a, b;
  a.mean << 1e6, 0.0, 0.0, 0.0;
  b.mean << 1e6 + 4.0, 0.0, 0.0, 0.0;
  a.covariance = b.covariance = Eigen::Matrix4d::Identity();
  ModeSum sum(a.mean);
  sum.add(3.0, a);
  sum.add(1.0, b);
  const GaussianMode merged = sum.merged();
  EXPECT_DOUBLE_EQ(merged.weight, 4.0);
  EXPECT_NEAR(merged.mean(0), 1e6 + 1.0, 1e-9);
  EXPECT_NEAR(merged.covariance(0, 0), 1.0 + 0.75 * 1.0 + 0.25 * 9.0, 1e-9);  // 1 and 3 m off the mean
  EXPECT_NEAR(merged.covariance(1, 1), 1.0, 1e-12);
}

TEST(TargetMixture, MergesModelByModel) {
  GaussianTarget a;
  a.num_modes = 2;
  a.modes[0].weight = 0.75;
  a.modes[1].weight = 0.25;
  GaussianTarget b = a;
  b.modes[0].weight = 0.25;
  b.modes[1].weight = 0.75;
  b.modes[1].mean(0) = 4.0;
  TargetMixture mixture(a);
  mixture.add(0.2, a);
  mixture.add(0.2, b);
  const GaussianTarget merged = mixture.merged();
  EXPECT_DOUBLE_EQ(mixture.weight(), 0.4);
  EXPECT_NEAR(merged.modes[0].weight, 0.5, 1e-12);
  EXPECT_NEAR(merged.modes[1].mean(0), 3.0, 1e-12);  // .75 of 4 m, .25 of 0
  EXPECT_DOUBLE_EQ(merged.modes[0].mean(0), 0.0);
}

}  // namespace
}  // namespace lookout::tracking
