#include "csht/joint/evidence/undetected_targets.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

TEST(UndetectedTargets, FallsFromThePriorAndTheSettlingToWhatEnters) {
  const ScanHistory scans = one_scan(0.3, 0.3);
  const TargetPrior prior;
  UndetectedTargets undetected({}, prior);
  double mean = undetected.update(scans.newest(), scans.figures(), 0.0);
  // 2.1 nats of 11 find those of the prior; those that appear are found from the next scan on.
  EXPECT_NEAR(mean, prior.expected_targets() * (1.0 - 2.1 / 11.0) + prior.appearing(0.0), 0.02);
  for (int k = 0; k < 100; ++k) mean = undetected.update(scans.newest(), scans.figures(), 0.5);
  // 0.0121 enter a scan (target_prior_test) and 0.001 appear; 2.1 nats of 11 find them.
  EXPECT_NEAR(mean, (0.0121 + 0.001) * 11.0 / 2.1, 0.005);
  EXPECT_NEAR(undetected.relative(), 0.001 * 11.0 / 2.1 / 2.0,
              1e-4);  // What enters is near the border.
}

}  // namespace
}  // namespace lookout::csht
