#include "csht/joint/trajectory_prior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

TEST(TrajectoryPrior, IsTargetsOverAreaAndVelocities) {
  ScanTable scan;
  fill_scan_table(posed_scan({}), scan);
  const TrajectoryPrior prior({.targets_per_view = 2.0, .max_speed = 5.0});
  // A quarter circle of 150 m, a disc of 5 m/s: by hand.
  const double volume = 0.25 * std::numbers::pi * 150.0 * 150.0 * std::numbers::pi * 25.0;
  EXPECT_NEAR(prior.log_density(scan), std::log(2.0 / volume), 1e-12);
}

TEST(TrajectoryPrior, RefusesNonsense) {
  EXPECT_THROW(TrajectoryPrior({.targets_per_view = 0.0}), std::invalid_argument);
  EXPECT_THROW(TrajectoryPrior({.interior_birth_rate = -1.0}), std::invalid_argument);
  EXPECT_THROW(TrajectoryPrior({.max_speed = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
