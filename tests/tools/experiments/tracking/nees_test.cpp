#include "tools/experiments/tracking/nees.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace lookout::tools {
namespace {

core::MotionElement element_at(double north, double east, double variance) {
  core::MotionElement element;
  element.position = {north, east};
  element.covariance = variance * Eigen::Matrix4d::Identity();
  return element;
}

core::GroundTruth two_targets() {
  core::GroundTruth truth;
  truth.targets.resize(2);
  truth.targets[0].position = {0.0, 0.0};
  truth.targets[1].position = {100.0, 0.0};
  return truth;
}

TEST(MeanNees, IsTheSquaredErrorInUnitsOfTheCovariance) {
  // 4 m off with a variance of 4 m^2: 16 / 4 over 4 degrees; 2 m off with 1 m^2: 4 / 1 over 4.
  const std::vector<core::MotionElement> elements{element_at(4.0, 0.0, 4.0), element_at(100.0, 2.0, 1.0)};
  EXPECT_DOUBLE_EQ(mean_nees(two_targets(), {elements.data(), 1}), 1.0);
  EXPECT_DOUBLE_EQ(mean_nees(two_targets(), elements), 1.0);
}

TEST(MeanNees, TakesTheNearestTarget) {
  const std::vector<core::MotionElement> elements{element_at(98.0, 0.0, 1.0)};
  EXPECT_DOUBLE_EQ(mean_nees(two_targets(), elements), 1.0);
}

TEST(MeanNees, CountsVelocity) {
  std::vector<core::MotionElement> elements{element_at(0.0, 0.0, 1.0)};
  elements[0].velocity = {0.0, 2.0};
  EXPECT_DOUBLE_EQ(mean_nees(two_targets(), elements), 1.0);
}

TEST(MeanNees, RefusesNothingToCompare) {
  EXPECT_THROW(mean_nees(two_targets(), {}), std::invalid_argument);
  const std::vector<core::MotionElement> elements(1);
  EXPECT_THROW(mean_nees({}, elements), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
