#include "csht/baselines/csht_printed_estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

// One target without errors: whatever the classes, one of them is on it within two of its 5 m cells.
TEST(CshtPrintedEstimator, FindsALoneTargetWithinItsCoarseGrid) {
  const testing::Course course{{80, 10}, {-1, 2}};
  CshtPrintedEstimator estimator({}, testing::sonar());
  double nearest = 1e9;
  for (const auto& scan : testing::scans_of({course})) {
    nearest = 1e9;
    for (const auto& element : estimator.update(scan))
      nearest = std::min(nearest, (element.position - course.at(9.5)).norm());
  }
  EXPECT_LT(nearest, 10.0);
}

TEST(CshtPrintedEstimator, WaitsForItsFirstScansAndFindsNothingInAnEmptySea) {
  CshtPrintedParams params;
  params.first_estimate_scans = 20;
  CshtPrintedEstimator estimator(params, testing::sonar());
  const auto scans = testing::scans_of({{{80, 10}, {-1, 2}}});
  for (std::size_t k = 0; k + 1 < scans.size(); ++k) EXPECT_TRUE(estimator.update(scans[k]).empty());
  EXPECT_FALSE(estimator.update(scans.back()).empty());
  CshtPrintedEstimator empty({}, testing::sonar());
  for (const auto& scan : testing::scans_of({})) EXPECT_TRUE(empty.update(scan).empty());
}

}  // namespace
}  // namespace lookout::csht
