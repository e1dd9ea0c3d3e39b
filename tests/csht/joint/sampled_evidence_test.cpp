#include "csht/joint/sampled_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "csht/joint/clusters.hpp"
#include "tests/csht/joint/joint_scenes.hpp"

namespace lookout::csht {
namespace {

using testing::Course;
const Course kCourse{{80, 10}, {-1, 2}};

TargetHypothesis start() {
  TargetHypothesis hypothesis;
  hypothesis.mean << kCourse.at(9.5), kCourse.velocity;
  hypothesis.covariance = Eigen::Vector4d(2, 2, 0.04, 0.04).asDiagonal();
  return hypothesis;
}

struct Found {
  TargetHypothesis hypothesis;
  double effective = 0.0;
};

Found evaluate(const ScanHistory& history, int samples, double birth_rate, std::uint64_t seed) {
  ClaimSet claims;
  claims.clear(history, history.size());
  JointEvidence evidence({.samples = samples});
  const TrajectoryPrior prior({.interior_birth_rate = birth_rate, .max_speed = 5.0});
  core::Random random(seed);
  Found found{start(), 0.0};
  evidence.evaluate(history, history.size(), claims, prior, evidence.stages(), random, found.hypothesis);
  found.effective = evidence.effective_samples();
  return found;
}

TEST(JointEvidence, FewSamplesAgreeWithMany) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1004), testing::noisy_figures());
  const Found many = evaluate(history, 20000, 0.0, 1);
  EXPECT_GT(many.hypothesis.log_odds, 10.0);
  for (std::uint64_t seed = 2; seed < 8; ++seed) {
    const Found few = evaluate(history, 160, 0.0, seed);
    // The error of a log evidence is about 1 / sqrt(effective samples); three of those.
    EXPECT_NEAR(few.hypothesis.log_odds, many.hypothesis.log_odds, 3.0 / std::sqrt(few.effective));
  }
}

// The verdict's sharper edges leave fewer samples that count; they still agree with very many.
TEST(JointEvidence, TheVerdictAgreesWithMany) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1004), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 20);
  const TrajectoryPrior prior({.interior_birth_rate = 0.0, .max_speed = 5.0});
  const auto decide = [&](int samples, std::uint64_t seed) {
    JointEvidence evidence({.verdict_samples = samples});
    core::Random random(seed);
    Found found{evaluate(history, 160, 0.0, seed).hypothesis, 0.0};
    evidence.decide(history, 20, claims, prior, random, found.hypothesis);
    found.effective = evidence.effective_samples();
    return found;
  };
  const Found many = decide(50000, 1);
  const int verdict_samples = JointEvidenceParams{}.verdict_samples;
  for (std::uint64_t seed = 2; seed < 8; ++seed) {
    const Found few = decide(verdict_samples, seed);
    EXPECT_NEAR(few.hypothesis.log_odds, many.hypothesis.log_odds, 3.0 / std::sqrt(few.effective));
  }
}

// Forty scans are more than one product holds. A narrow peak's evidence is near Laplace's, and births change
// little of a target that was there from the first scan.
TEST(JointEvidence, LongWindowsKeepTheirEvidence) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 40, 9, 1005), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 40);
  std::vector<TargetHypothesis> peak{start()};
  peak[0].mean << kCourse.at(19.5), kCourse.velocity;
  const TrajectoryPrior prior({.interior_birth_rate = 0.0, .max_speed = 5.0});
  JointClusters({}).refine(history, 40, claims, prior, peak);
  const auto sampled = [&](double birth_rate) {
    JointEvidence evidence({.samples = 4000});
    core::Random random(5);
    TargetHypothesis hypothesis = peak[0];
    evidence.evaluate(history, 40, claims,
                      TrajectoryPrior({.interior_birth_rate = birth_rate, .max_speed = 5.0}), 3, random,
                      hypothesis);
    return hypothesis.log_odds;
  };
  EXPECT_NEAR(sampled(0.0), peak[0].log_odds, 3.0);
  EXPECT_NEAR(sampled(0.001), sampled(0.0), 0.2);
}

// One silent scan, and a cloud of hypotheses in view: the evidence is P_M / (1 - P_F) times the prior mass
// of the cloud, the integral of a constant, which the sum over samples must return; and as much as the echoes
// are worth that noise took beyond the range: at sigma / sqrt(2 pi) x the arc of the sector, 2 sigma /
// (sqrt(2 pi) R) of its area.
TEST(JointEvidence, IntegratesAConstant) {
  const auto history = testing::history_of(testing::scans_of({}, 1), testing::noisy_figures());
  JointEvidence evidence({.samples = 4000, .stages = 1});
  const TrajectoryPrior prior({.interior_birth_rate = 0.0, .max_speed = 5.0});
  ClaimSet claims;
  claims.clear(history, 1);
  core::Random random(3);
  TargetHypothesis hypothesis;
  hypothesis.mean << 80.0, 0.0, 0.0, 0.0;
  hypothesis.covariance = Eigen::Vector4d(900.0, 900.0, 6.0, 6.0).asDiagonal();
  evidence.evaluate(history, 1, claims, prior, 1, random, hypothesis);
  // All of the prior lies within a few sigma of this proposal: two targets per view, each 0.1 / 0.9.
  const double beyond = 2.0 * 3.0 / (std::sqrt(2.0 * std::numbers::pi) * 150.0);
  EXPECT_NEAR(std::exp(hypothesis.log_odds), 2.0 * (0.1 / 0.9 + beyond), 0.02);
}

TEST(JointEvidence, ATargetThatCameLateHasItsEvidenceByBirths) {
  auto scans = testing::scans_of({kCourse}, 20);
  for (std::size_t k = 0; k < 8; ++k) scans[k].scan.returns.clear();
  const auto history = testing::history_of(scans, testing::noisy_figures());
  const double without = evaluate(history, 400, 0.0, 1).hypothesis.log_odds;
  const double with = evaluate(history, 400, 0.001, 1).hypothesis.log_odds;
  // Eight silences cost 8 ln(0.1 / 0.9) = -17.6; a birth costs ln(0.001 / 2) = -7.6.
  EXPECT_NEAR(with - without, 17.6 - 7.6, 0.6);
}

// More samples in the first stages than in any later one find room, and the same peak.
TEST(JointEvidence, ScreensWithAnyNumberOfSamples) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1004), testing::noisy_figures());
  JointEvidence evidence({.samples = 160, .screen_samples = 2000});
  ClaimSet claims;
  claims.clear(history, 20);
  core::Random random(6);
  TargetHypothesis hypothesis = start();
  evidence.evaluate(history, 20, claims, TrajectoryPrior({.interior_birth_rate = 0.0, .max_speed = 5.0}), 3,
                    random, hypothesis);
  EXPECT_GT(hypothesis.log_odds, 10.0);
}

TEST(JointEvidence, RefusesNonsense) {
  EXPECT_THROW(JointEvidence({.samples = 4}), std::invalid_argument);
  EXPECT_THROW(JointEvidence({.screen_samples = 4}), std::invalid_argument);
  EXPECT_THROW(JointEvidence({.stages = 0}), std::invalid_argument);
  EXPECT_THROW(JointEvidence({.proposal_scale = 3.0, .wide_scale = 2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
