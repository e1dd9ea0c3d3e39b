#include "tracking/joint/proposed_seed.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(SeedOf, TakesStateSpreadAndAgeOfTheProposal) {
  csht::ScanHistory scans({}, {}, 30);
  for (int k = 0; k < 20; ++k) scans.push(scan_of(k, {}));
  core::MotionElement element;
  element.position = {60.0, 10.0};
  element.velocity = {1.0, -0.5};
  element.covariance = 4.0 * Eigen::Matrix4d::Identity();
  element.initial_utime = 7'000'000;  // Scan 14 of 0 .. 19.
  const csht::BirthSeed seed = seed_of(element, scans);
  EXPECT_EQ(seed.guess.mean.head<4>(), Eigen::Vector4d(60.0, 10.0, 1.0, -0.5));
  EXPECT_DOUBLE_EQ(seed.guess.covariance(2, 2), 4.0);
  EXPECT_EQ(seed.start_age, 5);
}

}  // namespace
}  // namespace lookout::tracking
