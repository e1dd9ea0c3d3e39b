#include "csht/joint/evidence/error_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {
namespace {

// Scans of a target that is known to be 100 m north of the sonar, whose returns err by `error` of the stated
// sigmas.
double factor_after(int scans, double error) {
  core::SonarParams sonar;
  sonar.clutter_per_scan = 1.0;
  sonar.miss_probability = 0.1;
  sonar.range_sigma = 4.0;
  sonar.bearing_sigma = 0.02;
  ScanLikelihood likelihood(figures_of(sonar), {.clutter = ClutterModel::point}, {}, 4, 1);
  TrajectoryCloud cloud;
  cloud.resize(1);
  cloud.north[0] = 100.0;
  cloud.east[0] = cloud.north_velocity[0] = cloud.east_velocity[0] = 0.0;
  cloud.weight[0] = 1.0;
  core::Random random(3, core::RandomStream::simulator);
  ErrorScale errors;
  for (int k = 0; k < scans; ++k) {
    core::PosedScan scan;
    scan.scan.utime = 1'000'000L * k;
    scan.scan.num_beams = 360;
    scan.scan.first_bearing = core::radians(-179.5);
    scan.scan.bearing_step = core::radians(1.0);
    scan.scan.max_range = 500.0;
    scan.scan.returns = {{random.gaussian(error * 0.02), 100.0 + random.gaussian(error * 4.0)}};
    likelihood.push(scan);
    errors.take(cloud, likelihood.scans().newest(), nullptr, 1.0);
  }
  return errors.factor();
}

TEST(ErrorScale, TheStatedErrorsHoldBeforeAnythingIsKnown) {
  EXPECT_NEAR(factor_after(0, 1.0), 1.0, 0.05);
}

TEST(ErrorScale, ReturnsTellHowLargeTheErrorsAre) {
  EXPECT_NEAR(factor_after(60, 1.0), 1.0, 0.1);
  EXPECT_NEAR(factor_after(60, 0.5), 0.5, 0.05);
  EXPECT_NEAR(factor_after(60, 2.0), 2.0, 0.2);
}

// What differences from scan to scan do not show is not taken for absent.
TEST(ErrorScale, NeverIsLessBelievedThanHalf) {
  EXPECT_GE(factor_after(60, 0.1), 0.5);
}

}  // namespace
}  // namespace lookout::csht
