#include "tracking/track_before_detect/images/course_mixture.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>

#include "core/frames.hpp"
#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr double kStep = 0.5;          // s
constexpr double kSpeed = 0.8;         // m/s
constexpr double kNoise = 0.05;        // m
constexpr double kFreeDensity = 4e-4;  // m^2/s^3
const CellCourseParams kParams;

/// Position and velocity of a target that turns at `rate` [rad/s] from north.
Eigen::Vector4d truth_at(double time, double rate) {
  const double s = std::sin(rate * time), c = std::cos(rate * time);
  if (rate == 0.0) return {kSpeed * time, 0.0, kSpeed, 0.0};
  return {kSpeed * s / rate, kSpeed * (1.0 - c) / rate, kSpeed * c, kSpeed * s};
}

/// Follows such a target for so many pings, the places measured as they are but for noise.
CourseMixture followed(double rate, int pings) {
  core::Random random(2001);
  CourseMixture course;
  course.begin(truth_at(0.0, rate), 0.04 * Eigen::Matrix4d::Identity(), kParams);
  for (int k = 1; k <= pings; ++k) {
    course.predict(kStep, kFreeDensity, kParams);
    const Eigen::Vector2d measured =
        truth_at(k * kStep, rate).head<2>() + kNoise * Eigen::Vector2d(random.gaussian(), random.gaussian());
    const Eigen::Vector2d expected = course.merged().mean.head<2>();
    course.update({expected, Eigen::Matrix2d::Identity(), measured - expected,
                   Eigen::Array2d::Constant(kNoise * kNoise)});
  }
  return course;
}

/// Squared error of the state over its covariance and its four degrees.
double nees(const CourseMixture& course, const Eigen::Vector4d& truth) {
  const GaussianMode published = course.merged();
  const Eigen::Vector4d error = published.mean - truth;
  return error.dot(published.covariance.llt().solve(error)) / 4.0;
}

TEST(CourseMixture, KnowsNothingBeforeItBegins) {
  CourseMixture course;
  course.predict(kStep, kFreeDensity, kParams);
  course.update({});
  EXPECT_FALSE(course.begun());
}

TEST(CourseMixture, BeginsAsTheGaussianItWasGiven) {
  CourseMixture course;
  const Eigen::Vector4d state(1.0, 2.0, 0.3, -0.4);
  course.begin(state, 0.04 * Eigen::Matrix4d::Identity(), kParams);
  EXPECT_TRUE(course.merged().mean.isApprox(state));
  EXPECT_TRUE(course.merged().covariance.isApprox(0.04 * Eigen::Matrix4d::Identity()));
  EXPECT_DOUBLE_EQ(course.straight(), kParams.straight_share);
}

// A straight line through n places a step T apart leaves a velocity of sigma sqrt(12 / n^3) / T: .002 m/s for
// n = 40.
TEST(CourseMixture, IsSureOfAStraightCourse) {
  const CourseMixture course = followed(0.0, 40);
  EXPECT_GT(course.straight(), kParams.sure_straight);
  EXPECT_NEAR((course.merged().mean - truth_at(20.0, 0.0)).tail<2>().norm(), 0.0, 0.006);
  EXPECT_LT(nees(course, truth_at(20.0, 0.0)), 3.3);  // 99 of 100 of chi-square at 4 degrees
}

TEST(CourseMixture, FollowsTurnsEitherWay) {
  for (const double rate : {core::radians(2.0), -core::radians(2.0), core::radians(5.0)}) {
    const CourseMixture course = followed(rate, 40);
    EXPECT_LT(course.straight(), 0.01);
    EXPECT_LT((course.merged().mean - truth_at(20.0, rate)).tail<2>().norm(), 0.06);
    EXPECT_LT(nees(course, truth_at(20.0, rate)), 3.3);
  }
}

TEST(CourseMixture, ChecksItsParameters) {
  CellCourseParams params;
  EXPECT_NO_THROW(check(params));
  params.course_time = 0.0;
  EXPECT_THROW(check(params), std::invalid_argument);
  params = {};
  params.straight_share = 1.0;
  EXPECT_THROW(check(params), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
