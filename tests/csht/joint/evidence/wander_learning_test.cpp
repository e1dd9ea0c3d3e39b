#include "csht/joint/evidence/wander_learning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/random.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {
namespace {

constexpr double kPeriod = 2.0;   // [s].
constexpr double kSigma = 4.0;    // As stated [m];
constexpr double kAcross = 0.02;  // the same at 200 m [rad].

core::SonarParams radar(std::optional<double> wander = {}) {
  core::SonarParams sonar;
  sonar.num_beams = 360;
  sonar.first_bearing = core::radians(-179.5);
  sonar.max_range = 500.0;
  sonar.clutter_per_scan = 1.0;
  sonar.miss_probability = 0.1;
  sonar.range_sigma = kSigma;
  sonar.bearing_sigma = kAcross;
  sonar.scan_period = kPeriod;
  sonar.max_speed = 6.0;
  sonar.wander = wander;
  return sonar;
}

core::PosedScan scan_at(int index, const Eigen::Vector2d& seen) {
  core::PosedScan posed;
  posed.scan.utime = static_cast<std::int64_t>(1e6 * kPeriod) * index;
  posed.scan.num_beams = 360;
  posed.scan.first_bearing = core::radians(-179.5);
  posed.scan.bearing_step = core::radians(1.0);
  posed.scan.max_range = 500.0;
  posed.scan.returns = {{std::atan2(seen.y(), seen.x()), seen.norm()}};
  return posed;
}

/// What is learnt from a target that passes 200 m off at 3 m/s, strays by `rate` and whose returns err by
/// `error` of the stated errors. @param claimed by another target.
WanderEstimate learnt(int scans, double rate, double error, const core::SonarParams& sonar,
                      bool claimed = false) {
  WanderLearning learning(sonar);
  ScanLikelihood likelihood(figures_of(sonar), {.clutter = ClutterModel::point}, {}, 4, 1);
  core::Random random(5, core::RandomStream::simulator);
  TargetTrack track;
  track.used = true;
  track.id = 1;
  Eigen::Vector2d place(200.0, -100.0), velocity(0.0, 3.0);
  track.moments.mean << place, velocity, 0.0, 0.0;
  BeamMask mask;
  for (int k = 0; k < scans; ++k) {
    const Eigen::Vector2d seen =
        place + error * kSigma * Eigen::Vector2d(random.gaussian(1.0), random.gaussian(1.0));
    likelihood.push(scan_at(k, seen));
    mask.share = {claimed ? 1.0F : 0.0F};
    learning.take(track, likelihood.scans().newest(), &mask);
    place += kPeriod * velocity;
    velocity += rate * std::sqrt(kPeriod) * Eigen::Vector2d(random.gaussian(1.0), random.gaussian(1.0));
  }
  return learning.estimate();
}

TEST(WanderLearning, NothingIsKnownAtFirst) {
  const WanderEstimate estimate = learnt(0, 0.0, 1.0, radar());
  EXPECT_NEAR(estimate.probability, 0.5, 1e-9);
  EXPECT_NEAR(estimate.error_factor, 1.0, 0.01);
}

TEST(WanderLearning, LinesAreToldFromTargetsThatStray) {
  EXPECT_LT(learnt(60, 0.0, 1.0, radar()).probability, 0.5);
  const WanderEstimate estimate = learnt(60, 0.15, 1.0, radar());
  EXPECT_GT(estimate.probability, 0.98);
  EXPECT_LT(std::abs(std::log(estimate.rate / 0.15)), 2.0 * estimate.log_sigma + 0.1);
  EXPECT_LT(estimate.log_sigma, 0.7);
}

TEST(WanderLearning, ReturnsTellHowLargeTheErrorsAre) {
  EXPECT_NEAR(learnt(60, 0.0, 1.0, radar()).error_factor, 1.0, 0.1);
  EXPECT_NEAR(learnt(60, 0.15, 0.5, radar()).error_factor, 0.5, 0.06);
  EXPECT_GT(learnt(60, 0.0, 2.0, radar()).error_factor, 1.3);
}

// What differences from scan to scan do not show is not taken for absent, and a target that strays so fast
// that four scans hold nothing of it is none.
TEST(WanderLearning, IsBounded) {
  EXPECT_GE(learnt(60, 0.0, 0.1, radar()).error_factor, 0.5);
  const double fastest = 2.0 * kSigma / (16.0 * std::pow(kPeriod, 1.5));
  EXPECT_LE(learnt(60, 2.0, 1.0, radar()).rate, 1.001 * fastest);
}

TEST(WanderLearning, AStatedRateStands) {
  const WanderEstimate estimate = learnt(60, 0.02, 0.5, radar(0.2));
  EXPECT_NEAR(estimate.rate, 0.2, 1e-9);
  EXPECT_NEAR(estimate.error_factor, 0.5, 0.06);
}

TEST(WanderLearning, TheReturnsOfOthersTeachNothing) {
  EXPECT_NEAR(learnt(60, 0.15, 1.0, radar(), true).probability, 0.5, 1e-9);
}

TEST(WanderLearning, SensorsWithBeamsLearnNothing) {
  core::SonarParams beams = radar();
  beams.clutter_per_scan.reset();
  EXPECT_NEAR(learnt(60, 0.15, 1.0, beams).probability, 0.5, 1e-9);
}

}  // namespace
}  // namespace lookout::csht
