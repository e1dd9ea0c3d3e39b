#include "tracking/baselines/gaussian/switching_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tracking {
namespace {

GaussianTarget born(const SwitchingMotion& motion) {
  return motion.born({{10.0, 20.0}, 4.0 * Eigen::Matrix2d::Identity()});
}

TEST(SwitchingMotion, ANewTargetIsUncertainByItsSpeed) {
  SwitchingMotionParams params;
  params.first_speed = 0.5;
  const GaussianTarget target = born(SwitchingMotion(params, {}));
  EXPECT_EQ(target.mean(), Eigen::Vector4d(10.0, 20.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(target.covariance()(2, 2), 1.5 * 1.5);  // half of the default sonar's 3 m/s
}

TEST(SwitchingMotion, ASteadyTargetWalksByItsShareOfTheFastest) {
  SwitchingMotionParams params;
  params.models = 1;
  params.steady_walk = 0.1;
  const core::SonarParams sonar;
  const SwitchingMotion motion(params, sonar);
  GaussianTarget target = born(motion);
  const double before = target.covariance()(2, 2);
  motion.predict(target, sonar.scan_period);
  EXPECT_NEAR(target.covariance()(2, 2) - before, std::pow(0.1 * sonar.max_speed, 2), 1e-12);
}

TEST(SwitchingMotion, StepsMayBeCutAnywhere) {
  const SwitchingMotion motion({.models = 1, .steady_walk = 0.1}, {});
  GaussianTarget once = born(motion), twice = once;
  motion.predict(once, 1.5);
  motion.predict(twice, 0.4);
  motion.predict(twice, 1.1);
  EXPECT_LT((once.covariance() - twice.covariance()).norm(), 1e-9);
}

TEST(SwitchingMotion, ModelsSettleToTheirShares) {
  SwitchingMotionParams params;
  params.steady_scans = 30.0;
  params.turning_scans = 10.0;
  const SwitchingMotion motion(params, {});
  GaussianTarget target = born(motion);
  target.modes[0].weight = 1.0;
  target.modes[1].weight = 0.0;
  const double first = target.modes[0].weight;
  motion.predict(target, 0.5);
  EXPECT_NEAR(first - target.modes[0].weight, 1.0 - std::exp(-1.0 / 30.0), 1e-12);  // one scan period
  EXPECT_NEAR(target.modes[0].weight + target.modes[1].weight, 1.0, 1e-12);
  for (int k = 0; k < 200; ++k) motion.predict(target, 0.5);
  // The stationary share of a two-state chain: leaves at 1 - e^(-1/30), comes back at 1 - e^(-1/10).
  const double leaves = -std::expm1(-1.0 / 30.0), comes = -std::expm1(-1.0 / 10.0);
  EXPECT_NEAR(target.modes[0].weight, comes / (comes + leaves), 1e-6);
}

TEST(SwitchingMotion, RefusesParametersOutOfRange) {
  for (const SwitchingMotionParams& params :
       {SwitchingMotionParams{.models = 3}, SwitchingMotionParams{.steady_walk = -1.0},
        SwitchingMotionParams{.turning_scans = 0.0}, SwitchingMotionParams{.first_speed = 0.0}})
    EXPECT_THROW(SwitchingMotion(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
