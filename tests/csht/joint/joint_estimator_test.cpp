#include "csht/joint/joint_estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "core/field_of_view.hpp"
#include "csht/joint/density/sensor_scale.hpp"
#include "tests/csht/joint/noisy_scans.hpp"

namespace lookout::csht {
namespace {

using testing::Course;

core::SonarParams known_sonar() {
  core::SonarParams params = testing::sonar();
  params.miss_probability = 0.1;
  params.false_alarm_probability = 0.1;
  return params;
}

std::vector<core::MotionElement> estimate(JointEstimator& estimator,
                                          const std::vector<core::PosedScan>& scans) {
  std::vector<core::MotionElement> elements;
  for (const auto& scan : scans) {
    const auto found = estimator.update(scan);
    elements.assign(found.begin(), found.end());
  }
  return elements;
}

TEST(JointEstimator, ReportsWhereTheTargetsAre) {
  const std::vector<Course> courses{{{80, 10}, {-1, 2}}, {{60, -30}, {2, 1}}, {{40, 20}, {1, -3}}};
  JointEstimator estimator(JointEstimatorParams::window(), known_sonar(), 1);
  const auto elements = estimate(estimator, testing::noisy_scans(courses, 20, 9, 1007));
  ASSERT_EQ(elements.size(), 3u);
  for (const auto& course : courses) {
    const auto distance = [&](const auto& e) { return (e.position - course.at(9.5)).norm(); };
    const auto nearest = std::min_element(elements.begin(), elements.end(),
                                          [&](auto& a, auto& b) { return distance(a) < distance(b); });
    EXPECT_LT(distance(*nearest), 4.5);  // Three times the bound of least squares, 1.1 to 1.5 m.
    EXPECT_LT((nearest->velocity - course.velocity).norm(), 1.2);
    EXPECT_GT(nearest->existence, 0.99);
    EXPECT_EQ(nearest->initial_utime, 0);
  }
}

// Faster targets shorten what the tracker pairs within (10 s at 3 m/s), but a window is searched whole: at
// P_M = .7 a target has too few detections to leave out those of the longest lags.
TEST(JointEstimator, PairsDetectionsOverTheWholeWindowHoweverFastTargetsAre) {
  core::SonarParams fast = known_sonar();
  fast.max_speed = 5.0;
  const double window = 20 * fast.scan_period;
  EXPECT_LT(scaled(JointEngineParams(), SensorScale::of(fast)).birth.max_lag_s, window);
  EXPECT_GE(scaled(window_engine(), SensorScale::of(fast)).birth.max_lag_s, window);
}

// The sea looks the same from a sonar that is turned with it: the answer turns along.
TEST(JointEstimator, TurnsWithTheScene) {
  const auto scans = testing::noisy_scans({{{80, 10}, {-1, 2}}}, 20, 9, 1008);
  auto turned = scans;
  for (auto& scan : turned) scan.T_earth_sonar = {100.0, -40.0, core::radians(120.0)};
  JointEstimator first({}, known_sonar(), 1), second({}, known_sonar(), 1);
  const auto straight = estimate(first, scans), rotated = estimate(second, turned);
  ASSERT_EQ(straight.size(), 1u);
  ASSERT_EQ(rotated.size(), 1u);
  const Eigen::Vector2d expected =
      core::transform({100.0, -40.0, core::radians(120.0)}, straight[0].position);
  // Two Monte Carlo answers to one question: within half the standard error of either.
  EXPECT_LT((rotated[0].position - expected).norm(), 0.7);
}

TEST(JointEstimator, IsRepeatable) {
  const auto scans = testing::noisy_scans({{{80, 10}, {-1, 2}}}, 20, 20, 1009);
  JointEstimator first({}, known_sonar(), 7), second({}, known_sonar(), 7);
  const auto a = estimate(first, scans), b = estimate(second, scans);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].state(), b[k].state());
}

TEST(JointEstimator, ForgetsATargetThatHasLeft) {
  auto scans = testing::noisy_scans({{{80, 10}, {-1, 2}}}, 45, 9, 1010);
  for (std::size_t k = 20; k < scans.size(); ++k)
    std::erase_if(scans[k].scan.returns, [](const auto& r) { return std::abs(r.bearing) < 1.0; });
  JointEstimator estimator({}, known_sonar(), 1);
  EXPECT_TRUE(estimate(estimator, scans).empty());
}

// 200 scans without a target: nine windows beside the prior's two, 2 targets x 2 / 11 = 0.36 remain.
TEST(JointEstimator, AnEmptySeaBecomesHardToConvince) {
  JointEstimator estimator({}, known_sonar(), 1);
  EXPECT_TRUE(estimate(estimator, testing::noisy_scans({}, 200, 9, 1014)).empty());
  EXPECT_NEAR(estimator.scene().prior.expected_targets(), 0.40, 0.06);
}

TEST(JointEstimator, RefusesNonsense) {
  JointEstimatorParams short_window, too_sure;
  short_window.window_scans = 2;
  too_sure.min_existence = 1.5;
  EXPECT_THROW(JointEstimator(short_window, known_sonar(), 1), std::invalid_argument);
  EXPECT_THROW(JointEstimator(too_sure, known_sonar(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
