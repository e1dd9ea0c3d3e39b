#include "csht/joint/evidence/scan_information.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

// Closed form for P_M = P_F = p, false alarms uniform over the range R and a Gaussian error sigma: a
// detection brings ln((1 - p)/p R/(sqrt(2 pi) sigma)) less the mean 1/2 of its squared error's half, a
// silence ln(p/(1 - p)). For the default sonar 4.00, 2.08, 1.25, 1.09 nats.
TEST(NatsPerScan, OfTheDiagonal) {
  const core::SonarParams sonar;
  const double sharpness = sonar.max_range / (std::sqrt(2.0 * std::numbers::pi) * sonar.range_sigma);
  for (const double p : {0.1, 0.3, 0.5, 0.7}) {
    const ScanHistory scans = one_scan(p, p);
    const double detection = std::log((1.0 - p) / p * sharpness) - 0.5, silence = std::log(p / (1.0 - p));
    EXPECT_NEAR(nats_per_scan(scans.figures(), scans.newest()), (1.0 - p) * detection + p * silence, 1e-5);
  }
}

TEST(NatsPerScan, AnUncertainBeamCostsItsEntropy) {
  SensorFigures figures;
  figures.miss_probability = figures.false_alarm_probability = 0.1;
  ScanHistory exact(figures, {}, 4);
  figures.heading_sigma = core::radians(2.0);  // Of beams of 1 degree.
  ScanHistory blurred(figures, {}, 4);
  exact.push(scan_of(0, {}));
  blurred.push(scan_of(0, {}));
  // ln(2 sqrt(2 pi e)) = 2.11 nats for each of 0.9 detections; what a silence loses is some hundredths.
  EXPECT_NEAR(
      nats_per_scan(exact.figures(), exact.newest()) - nats_per_scan(blurred.figures(), blurred.newest()),
      0.9 * 2.11, 0.05);
}

// Where false returns are ten times as dense, each of .9 detections says ln 10 less, and a silence what it
// did.
TEST(NatsPerScan, DenseClutterCostsItsLogarithm) {
  const ScanHistory scans = one_scan(0.1, 0.1);
  const double clear = nats_per_scan(scans.figures(), scans.newest());
  EXPECT_NEAR(clear - nats_per_scan(scans.figures(), scans.newest(), 0.1), 0.9 * std::log(10.0), 1e-6);
}

TEST(LogOvershoot, OfOddsThatCreepIsNothing) {
  EXPECT_NEAR(log_overshoot({0.5, 0.01, 0.01}), 0.0, 0.006);  // Half a step.
  EXPECT_EQ(log_overshoot({0.5, -1.0, -1.0}), 0.0);
}

// Whatever the scans bring: the mean of e^-overshoot over many sums of positive steps that cross a threshold.
TEST(LogOvershoot, IsThatOfSums) {
  for (const ScanEvidence evidence : {ScanEvidence{0.5, 2.16, 0.51}, ScanEvidence{0.3, 1.65, 0.85}}) {
    core::Random random(1013);
    const int crossings = 20000;
    double sum = 0.0;
    for (int k = 0; k < crossings; ++k) {
      double odds = -20.0 - random.uniform(0.0, 10.0);  // Longer than any period of the steps.
      while (odds < 0.0) odds += random.bernoulli(evidence.detect) ? evidence.detection : evidence.silence;
      sum += std::exp(-odds) / crossings;
    }
    EXPECT_NEAR(log_overshoot(evidence), std::log(sum), 0.02);  // Three standard errors are 0.01.
  }
}

TEST(LogOvershoot, SilenceThatSpeaksAgainstATargetIsNoStep) {
  EXPECT_DOUBLE_EQ(log_overshoot({0.7, 3.3, -0.9}), log_overshoot({1.0, 3.3, 0.0}));
}

}  // namespace
}  // namespace lookout::csht
