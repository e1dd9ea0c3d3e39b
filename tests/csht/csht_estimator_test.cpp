#include "csht/csht_estimator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
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

// Errors as the estimator believes them, 3 m along and a beam's share and the floor across, 100 windows: the
// errors in units of the reported covariance, squared, average 4 (chi-square, 4 degrees; +-0.33 for 300
// targets). The gate of chi-square 8 cuts 2 % of the detections, those with the largest errors.
TEST(CshtEstimator, CovarianceIsConsistent) {
  double sum = 0.0;
  int count = 0;
  for (int run = 0; run < 100; ++run) {
    core::Random random(1000, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
    CshtParams params = CshtParams::window();
    params.first_estimate_scans = 20;
    CshtEstimator estimator(params, testing::sonar());
    const auto elements = estimate(
        estimator,
        testing::scans_of(kCourses, 20, {3.0, std::sqrt(0.3 * 0.3 + 0.2 * 0.2), false, 0.1, 1}, random));
    if (elements.size() != kCourses.size()) continue;
    for (const auto& course : kCourses) {
      const auto& element = nearest(elements, course.at(9.5));
      Eigen::Vector4d error;
      error << element.position - course.at(9.5), element.velocity - course.velocity;
      sum += error.dot(element.covariance.llt().solve(error));
      ++count;
    }
  }
  ASSERT_GT(count, 280);
  EXPECT_GT(sum / count, 4.0 * 0.8);
  EXPECT_LT(sum / count, 4.0 * 1.25);
}

// Turn the vehicle and the whole scene with it by 30 degrees: the answer turns.
TEST(CshtEstimator, TurnsWithTheScene) {
  const double angle = core::radians(30.0);
  auto scans = testing::scans_of(kCourses);
  for (auto& scan : scans) scan.T_earth_sonar.heading = angle;
  CshtEstimator estimator(CshtParams::window(), testing::sonar());
  const auto elements = estimate(estimator, scans);
  ASSERT_EQ(elements.size(), kCourses.size());
  for (const auto& course : kCourses) {
    const Eigen::Vector2d expected = core::transform({0, 0, angle}, course.at(9.5));
    EXPECT_LT((nearest(elements, expected).position - expected).norm(), 0.3);
  }
}

// The estimator may not know P_F and P_M: told or not, it answers the same.
TEST(CshtEstimator, DoesNotUseTheProbabilities) {
  core::Random random(5);
  const auto scans = testing::scans_of(kCourses, 20, {3.0, 0.0, true, 0.3, 10}, random);
  core::SonarParams told = testing::sonar();
  told.miss_probability = 0.9;
  told.false_alarm_probability = 0.01;
  CshtEstimator plain(CshtParams::window(), testing::sonar()), knowing(CshtParams::window(), told);
  const auto a = estimate(plain, scans), b = estimate(knowing, scans);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].state(), b[k].state());
}

// Four detections in 20 scans are too few for the tracking set's evidence; offered as a track they suffice.
TEST(CshtEstimator, AcceptsAnOfferedTrackOnLessEvidence) {
  auto scans = testing::scans_of({kCourses[0]});
  for (std::size_t k = 0; k < scans.size(); ++k)
    if (k % 5 != 4) scans[k].scan.returns.clear();
  CshtParams params = CshtParams::tracking();
  params.decision.min_evidence = 1000.0;
  CshtEstimator alone(params, testing::sonar()), offered(params, testing::sonar());
  EXPECT_TRUE(estimate(alone, scans).empty());
  estimate(offered, {scans.begin(), scans.end() - 1});
  core::Track track;
  track.state << kCourses[0].at(9.0), kCourses[0].velocity;
  offered.offer({{&track, 1}});
  EXPECT_EQ(offered.update(scans.back()).size(), 1U);
}

TEST(CshtEstimator, KeepsItsVoteMatrixForAPicture) {
  CshtEstimator estimator(CshtParams::window(), testing::sonar());
  estimator.keep_snapshots();
  estimate(estimator, testing::scans_of(kCourses));
  for (const int axis : {0, 1}) {
    const VoteSnapshot& snapshot = estimator.snapshot(axis);
    EXPECT_GE(snapshot.classes.size(), kCourses.size());
    EXPECT_GT(snapshot.cells.size(), 100U);
    EXPECT_GT(snapshot.threshold, 0.0);
  }
}

TEST(CshtEstimator, ShowsTheValueThatItRefuses) {
  CshtParams params = CshtParams::window();
  params.window_scans = 1000;
  EXPECT_THROW(CshtEstimator(params, testing::sonar()), std::invalid_argument);
  params = CshtParams::window();
  params.passes = 0;
  EXPECT_THROW(CshtEstimator(params, testing::sonar()), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
