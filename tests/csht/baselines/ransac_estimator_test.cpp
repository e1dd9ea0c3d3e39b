#include "csht/baselines/ransac_estimator.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

using testing::Course;

std::vector<core::MotionElement> estimate(const std::vector<core::PosedScan>& scans) {
  RansacEstimator estimator({}, testing::sonar(), 1);
  std::vector<core::MotionElement> elements;
  for (const auto& scan : scans) {
    const auto found = estimator.update(scan);
    elements.assign(found.begin(), found.end());
  }
  return elements;
}

TEST(RansacEstimator, FollowsExactCourses) {
  const std::vector<Course> courses{{{80, 10}, {-1, 2}}, {{60, -30}, {2, 1}}};
  const auto elements = estimate(testing::scans_of(courses, 20));
  ASSERT_EQ(elements.size(), 2u);
  for (const auto& course : courses) {
    const auto error = [&](const auto& e) { return (e.position - course.at(9.5)).norm(); };
    const auto& nearest = error(elements[0]) < error(elements[1]) ? elements[0] : elements[1];
    EXPECT_LT(error(nearest), 1e-6);  // Exact detections on a straight line: regression is exact.
    EXPECT_LT((nearest.velocity - course.velocity).norm(), 1e-6);
  }
}

TEST(RansacEstimator, PrintsNothingAndRepeats) {
  core::Random random(1013);
  const auto scans = testing::scans_of({{{80, 10}, {-1, 2}}}, 20, {.clutter_per_scan = 5}, random);
  ::testing::internal::CaptureStdout();
  const auto first = estimate(scans), second = estimate(scans);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k) EXPECT_EQ(first[k].state(), second[k].state());
}

TEST(RansacEstimator, RefusesNonsense) {
  EXPECT_THROW(RansacEstimator({.window_scans = 1}, testing::sonar(), 1), std::invalid_argument);
  EXPECT_THROW(RansacEstimator({.threshold = 0.0}, testing::sonar(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
