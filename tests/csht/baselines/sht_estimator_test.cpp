#include "csht/baselines/sht_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

// Without errors the peak's cell holds the line: the error is at most half a cell, of 5 m and .88 m/s
// over 4.75 s, on either axis.
TEST(ShtEstimator, FindsALoneTargetWithinACell) {
  const testing::Course course{{80, 10}, {-1, 2}};
  ShtEstimator estimator({}, testing::sonar());
  double nearest = 1e9;
  for (const auto& scan : testing::scans_of({course})) {
    nearest = 1e9;
    for (const auto& element : estimator.update(scan))
      nearest = std::min(nearest, (element.position - course.at(9.5)).norm());
  }
  EXPECT_LT(nearest, std::sqrt(2.0) * (2.5 + 0.44 * 4.75));
}

TEST(ShtEstimator, FindsNothingInAnEmptySea) {
  ShtEstimator estimator({}, testing::sonar());
  for (const auto& scan : testing::scans_of({})) EXPECT_TRUE(estimator.update(scan).empty());
}

TEST(ShtEstimator, RefusesAThresholdOfOneAndAGridWithoutCells) {
  ShtParams params;
  params.threshold = 1.0;
  EXPECT_THROW(ShtEstimator(params, testing::sonar()), std::invalid_argument);
  params = {};
  params.intercept_step = 0.0;
  EXPECT_THROW(ShtEstimator(params, testing::sonar()), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
