#include "tracking/baselines/gaussian/weighted_target.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

WeightedTarget component(double weight, double north, std::int64_t label = 0) {
  WeightedTarget result{weight, {}, label};
  result.target.modes[0].mean << north, 0.0, 0.0, 0.0;
  result.target.modes[0].covariance = Eigen::Matrix4d::Identity();
  return result;
}

constexpr ReductionParams kParams{.least_share = 0.01, .merge_distance = 4.0, .most = 3};

TEST(WeightedTarget, CloseComponentsMergeAndKeepTheirMass) {
  std::vector<WeightedTarget> mixture{component(0.3, 1.0), component(0.6, 0.0), component(0.1, 10.0)};
  reduce(mixture, kParams);
  ASSERT_EQ(mixture.size(), 2U);
  EXPECT_NEAR(mixture[0].weight, 0.9, 1e-12);
  EXPECT_NEAR(mixture[0].target.mean()(0), 1.0 / 3.0, 1e-12);  // .3 of 1 m in .9
  EXPECT_NEAR(total_weight(mixture), 1.0, 1e-12);
}

TEST(WeightedTarget, LightOnesGoAndTheMassStays) {
  std::vector<WeightedTarget> mixture{component(0.5, 0.0), component(0.004, 50.0)};
  reduce(mixture, kParams);
  ASSERT_EQ(mixture.size(), 1U);
  EXPECT_NEAR(mixture[0].weight, 0.504, 1e-12);
}

TEST(WeightedTarget, TheHeaviestAreKept) {
  std::vector<WeightedTarget> mixture;
  for (int k = 0; k < 6; ++k) mixture.push_back(component(1.0 + k, 20.0 * k));
  reduce(mixture, kParams);
  ASSERT_EQ(mixture.size(), 3U);
  EXPECT_DOUBLE_EQ(mixture[0].target.mean()(0), 100.0);
  EXPECT_NEAR(total_weight(mixture), 21.0, 1e-9);
}

TEST(WeightedTarget, LabelsAreNotMixed) {
  std::vector<WeightedTarget> mixture{component(0.5, 0.0, 1), component(0.4, 0.1, 2)};
  reduce(mixture, kParams);
  EXPECT_EQ(mixture.size(), 2U);
}

TEST(WeightedTarget, AcrossLabelsTheHeavierOneStays) {
  std::vector<WeightedTarget> mixture{component(0.4, 0.0, 1), component(0.5, 0.1, 2)};
  mixture[0].detected = 0.3;
  ReductionParams params = kParams;
  params.across_labels = true;
  reduce(mixture, params);
  ASSERT_EQ(mixture.size(), 1U);
  EXPECT_EQ(mixture[0].label, 2);
  EXPECT_DOUBLE_EQ(mixture[0].detected, 0.3);
}

TEST(WeightedTarget, RefusesParametersOutOfRange) {
  for (const ReductionParams& params : {ReductionParams{.least_share = 1.0},
                                        ReductionParams{.merge_distance = -1.0}, ReductionParams{.most = 0}})
    EXPECT_THROW(params.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
