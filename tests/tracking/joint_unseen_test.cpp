#include "tracking/joint_unseen.hpp"

#include <gtest/gtest.h>

#include "csht/scan_history.hpp"
#include "tests/tracking/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

csht::ScanHistory one_scan(double miss, double false_alarm) {
  csht::SensorFigures figures;
  figures.miss_probability = miss;
  figures.false_alarm_probability = false_alarm;
  csht::ScanHistory scans(figures, {}, 4);
  scans.push(scan_of(0, {}));
  return scans;
}

// a prototype's study lists 4.0, 2.1, 1.3, 1.1 nats on the diagonal, to the accuracy of their printing.
TEST(NatsPerScan, OfTheDiagonal) {
  const double expected[] = {4.0, 2.1, 1.3, 1.1};
  for (int k = 0; k < 4; ++k) {
    const double p = 0.1 + 0.2 * k;
    const csht::ScanHistory scans = one_scan(p, p);
    EXPECT_NEAR(nats_per_scan(scans.figures(), scans.newest()), expected[k], 0.06);
  }
}

TEST(NatsPerScan, AnUncertainBeamCostsItsEntropy) {
  csht::SensorFigures figures;
  figures.miss_probability = figures.false_alarm_probability = 0.1;
  csht::ScanHistory exact(figures, {}, 4);
  figures.heading_sigma = core::radians(2.0);  // Of beams of 1 degree.
  csht::ScanHistory blurred(figures, {}, 4);
  exact.push(scan_of(0, {}));
  blurred.push(scan_of(0, {}));
  // ln(2 sqrt(2 pi e)) = 2.11 nats for each of 0.9 echoes; what a silence loses is some hundredths.
  EXPECT_NEAR(
      nats_per_scan(exact.figures(), exact.newest()) - nats_per_scan(blurred.figures(), blurred.newest()),
      0.9 * 2.11, 0.05);
}

TEST(JointUnseen, FallsFromThePriorAndTheSettlingToWhatEnters) {
  const csht::ScanHistory scans = one_scan(0.3, 0.3);
  const JointPrior prior;
  JointUnseen unseen({}, prior);
  double mean = unseen.update(scans.newest(), scans.figures(), 0.0);
  // 2.1 nats of 11 find those of the prior; those that come into sight are found from the next scan on.
  EXPECT_NEAR(mean, prior.expected_targets() * (1.0 - 2.1 / 11.0) + prior.appearing(0.0), 0.02);
  for (int k = 0; k < 100; ++k) mean = unseen.update(scans.newest(), scans.figures(), 0.5);
  // 0.0121 enter a scan (joint_prior_test) and 0.001 appear; 2.1 nats of 11 find them.
  EXPECT_NEAR(mean, (0.0121 + 0.001) * 11.0 / 2.1, 0.005);
  EXPECT_NEAR(unseen.relative(), mean / 2.0, 1e-12);
}

}  // namespace
}  // namespace lookout::tracking
