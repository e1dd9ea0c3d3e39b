#include "csht/refit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

const testing::Course kCourse{{60, 10}, {1, -2}};

HoughWindow window_of(const std::vector<core::PosedScan>& scans) {
  HoughWindow window(20, testing::sonar(), 0.2);
  for (const auto& scan : scans) window.add(scan);
  return window;
}

Candidate start_near(const testing::Course& course, double epoch) {
  Candidate candidate;
  const Eigen::Vector2d p = course.at(epoch) + Eigen::Vector2d(2.0, -1.5);
  candidate.state << p, course.velocity + Eigen::Vector2d(0.3, 0.3);
  return candidate;
}

TEST(Refit, ExactSamplesGiveTheExactCourse) {
  const auto window = window_of(testing::scans_of({kCourse}));
  Candidate candidate = start_near(kCourse, 4.75);
  const std::vector<char> free(window.detections().size(), 1);
  ASSERT_TRUE(Refit({}).fit(candidate, window, 4.75, free));
  EXPECT_EQ(candidate.support, 20);
  EXPECT_LT((candidate.position(0.0) - kCourse.at(4.75)).norm(), 1e-6);
  EXPECT_LT((candidate.state.tail<2>() - kCourse.velocity).norm(), 1e-6);
}

TEST(Refit, LeavesSamplesThatAreNotFree) {
  const auto window = window_of(testing::scans_of({kCourse}));
  Candidate candidate = start_near(kCourse, 4.75);
  std::vector<char> free(window.detections().size(), 1);
  std::fill(free.begin(), free.begin() + 15, 0);
  ASSERT_TRUE(Refit({}).fit(candidate, window, 4.75, free));
  EXPECT_EQ(candidate.support, 5);
  std::fill(free.begin(), free.end(), 0);
  EXPECT_FALSE(Refit({}).fit(candidate, window, 4.75, free));
}

TEST(Refit, RefusesAFitThatIsTooFast) {
  const testing::Course fast{{20, 0}, {9, 0}};
  const auto window = window_of(testing::scans_of({fast}));
  Candidate candidate = start_near(fast, 4.75);
  const std::vector<char> free(window.detections().size(), 1);
  EXPECT_FALSE(Refit({}).fit(candidate, window, 4.75, free));
}

// Straight north of the sonar the range error is north's: for 20 equal detections the covariance of the
// position at the epoch is sigma^2 / 20, that of the velocity sigma^2 / sum t^2.
TEST(Refit, CovarianceIsThatOfLeastSquares) {
  const testing::Course ahead{{60, 0}, {0, 0}};
  const auto window = window_of(testing::scans_of({ahead}));
  Candidate candidate = start_near(ahead, 4.75);
  const std::vector<char> free(window.detections().size(), 1);
  ASSERT_TRUE(Refit({}).fit(candidate, window, 4.75, free));
  double sum = 0.0;
  for (int k = 0; k < 20; ++k) sum += (0.5 * k - 4.75) * (0.5 * k - 4.75);
  EXPECT_NEAR(candidate.covariance(0, 0), 9.0 / 20.0, 1e-6);
  EXPECT_NEAR(candidate.covariance(2, 2), 9.0 / sum, 1e-6);
}

// The same 20 detections of a target at rest with a prior of .5 m/s: the information of the velocity grows by
// 1 / .5^2, its mean stays.
TEST(Refit, AVelocityPriorAddsItsInformation) {
  const testing::Course ahead{{60, 0}, {0, 0}};
  const auto window = window_of(testing::scans_of({ahead}));
  Candidate candidate = start_near(ahead, 4.75);
  const std::vector<char> free(window.detections().size(), 1);
  RefitParams params;
  params.velocity_sigma = 0.5;
  ASSERT_TRUE(Refit(params).fit(candidate, window, 4.75, free));
  double sum = 0.0;
  for (int k = 0; k < 20; ++k) sum += (0.5 * k - 4.75) * (0.5 * k - 4.75);
  EXPECT_NEAR(candidate.covariance(2, 2), 1.0 / (sum / 9.0 + 4.0), 1e-6);
  EXPECT_LT(candidate.state.tail<2>().norm(), 1e-6);
}

// Three detections in one second whose range errors pretend 9 m/s: without a prior the fit is too fast and
// the target lost, with one it is kept, and slower than the sensor's fastest.
TEST(Refit, AVelocityPriorKeepsTheFirstDetectionsOfATarget) {
  const testing::Course seeming{{60, 0}, {9, 0}};
  const auto window = window_of(testing::scans_of({seeming}, 3));
  const std::vector<char> free(window.detections().size(), 1);
  RefitParams params;
  params.max_speed = 4.0;
  Candidate candidate = start_near({seeming.at(0.5), {0, 0}}, 0.0);
  EXPECT_FALSE(Refit(params).fit(candidate, window, 0.5, free));
  params.velocity_sigma = 1.5;
  candidate = start_near({seeming.at(0.5), {0, 0}}, 0.0);
  ASSERT_TRUE(Refit(params).fit(candidate, window, 0.5, free));
  EXPECT_EQ(candidate.support, 3);
  EXPECT_GT(candidate.state[2], 0.0);
}

TEST(Refit, RefusesANegativePrior) {
  RefitParams params;
  params.velocity_sigma = -1.0;
  EXPECT_THROW(Refit{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
