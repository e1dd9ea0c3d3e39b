#include "csht/elements.hpp"

#include <gtest/gtest.h>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

// A state at the middle of the window, 4.75 s before its end: the position drifts by 4.75 v, and its variance
// grows by 4.75^2 times the velocity's.
TEST(Elements, AreAtTheNewestScan) {
  HoughWindow window(20, testing::sonar(), 0.2);
  for (const auto& scan : testing::scans_of({})) window.add(scan);
  Candidate candidate;
  candidate.state << 10.0, 20.0, 1.0, -2.0;
  candidate.covariance.diagonal() << 0.5, 0.5, 0.1, 0.1;
  candidate.support = 7;
  const auto element = to_element(candidate, window, 4.75);
  EXPECT_TRUE(element.position.isApprox(Eigen::Vector2d(14.75, 10.5)));
  EXPECT_TRUE(element.initial_position.isApprox(Eigen::Vector2d(5.25, 29.5)));
  EXPECT_EQ(element.initial_utime, 0);
  EXPECT_DOUBLE_EQ(element.covariance(0, 0), 0.5 + 4.75 * 4.75 * 0.1);
  EXPECT_DOUBLE_EQ(element.covariance(0, 2), 4.75 * 0.1);
  EXPECT_EQ(element.support, 7);
  EXPECT_FALSE(element.of_known_track);
  candidate.offered = true;
  EXPECT_TRUE(to_element(candidate, window, 4.75).of_known_track);
}

}  // namespace
}  // namespace lookout::csht
