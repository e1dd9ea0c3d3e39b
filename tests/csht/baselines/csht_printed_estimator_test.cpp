#include "csht/baselines/csht_printed_estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

/// Distance of the nearest element to a lone course after its window [m].
double miss_of(const CshtPrintedParams& params, const testing::Course& course) {
  CshtPrintedEstimator estimator(params, testing::sonar());
  double nearest = 1e9;
  for (const auto& scan : testing::scans_of({course})) {
    nearest = 1e9;
    for (const auto& element : estimator.update(scan))
      nearest = std::min(nearest, (element.position - course.at(9.5)).norm());
  }
  return nearest;
}

// Eq. (41) to the letter gives each detection to the class whose *current* position is nearest, which along a
// fast target's course is not its own: at the detection's own time the east line keeps more of its samples.
TEST(CshtPrintedEstimator, ItsDistancesAreThosePrinted) {
  const testing::Course fast{{100, 10}, {-4, 2}};
  CshtPrintedParams own_time;
  own_time.own_time = true;
  EXPECT_NE(miss_of({}, fast), miss_of(own_time, fast));
}

// One target without errors: whatever the classes, one of them is on it within two of its 5 m cells.
TEST(CshtPrintedEstimator, FindsALoneTargetWithinItsCoarseGrid) {
  const testing::Course course{{80, 10}, {-1, 2}};
  EXPECT_LT(miss_of({}, course), 10.0);
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
