#include "csht/csht_estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

using testing::Course;

/// Three courses inside the sector of a sonar that looks north.
const std::vector<Course> kCourses{{{80, 10}, {-1, 2}}, {{60, -30}, {2, 1}}, {{40, 20}, {1, -3}}};

std::vector<core::MotionElement> estimate(CshtEstimator& estimator,
                                          const std::vector<core::PosedScan>& scans) {
  std::vector<core::MotionElement> elements;
  for (const auto& scan : scans) {
    const auto found = estimator.update(scan);
    elements.assign(found.begin(), found.end());
  }
  return elements;
}

const core::MotionElement& nearest(const std::vector<core::MotionElement>& elements,
                                   const Eigen::Vector2d& p_earth) {
  return *std::min_element(elements.begin(), elements.end(), [&](const auto& a, const auto& b) {
    return (a.position - p_earth).norm() < (b.position - p_earth).norm();
  });
}

// The acceptance of the spine: without noise, quantisation, clutter and misses the error is at most a fifth
// of a grid step, 0.5 sigma = 1.5 m and 0.7 sigma / 4.75 s = 0.44 m/s, the estimator told sigma = 3 m.
TEST(CshtEstimator, FindsExactCoursesWithinAFifthOfAGridStep) {
  const CshtParams params = CshtParams::window();
  CshtEstimator estimator(params, testing::sonar());
  const auto elements = estimate(estimator, testing::scans_of(kCourses));
  ASSERT_EQ(elements.size(), kCourses.size());
  const HoughGrid grid = csht_grid(params, testing::sonar());
  for (const auto& course : kCourses) {
    const auto& element = nearest(elements, course.at(9.5));
    EXPECT_LT((element.position - course.at(9.5)).norm(), 0.2 * grid.intercept_step);
    EXPECT_LT((element.velocity - course.velocity).norm(), 0.2 * grid.velocity_step);
    EXPECT_LT((element.initial_position - course.at(0.0)).norm(), 0.2 * grid.intercept_step);
    EXPECT_EQ(element.initial_utime, 0);
    EXPECT_EQ(element.support, 20);
  }
}

TEST(CshtEstimator, FindsNothingInAnEmptySea) {
  CshtEstimator estimator(CshtParams::window(), testing::sonar());
  EXPECT_TRUE(estimate(estimator, testing::scans_of({})).empty());
}

}  // namespace
}  // namespace lookout::csht
