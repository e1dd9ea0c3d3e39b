#include "csht/count_decision.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "csht/refit.hpp"
#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

/// A window, and the fit to the course of its scene.
struct Fitted {
  HoughWindow window{20, testing::sonar(), 0.2};
  Candidate candidate;
  std::vector<char> free;

  Fitted(const std::vector<core::PosedScan>& scans, const testing::Course& course) {
    for (const auto& scan : scans) window.add(scan);
    free.assign(window.detections().size(), 1);
    candidate.state << course.at(window.centre_time()), course.velocity;
    EXPECT_TRUE(Refit({}).fit(candidate, window, window.centre_time(), free));
  }
  double evidence(const CountDecisionParams& params = {}) const {
    CountDecision decision(params);
    decision.prepare(window);
    return decision.log_evidence(candidate, window, window.centre_time(), free,
                                 static_cast<int>(free.size()));
  }
};

const testing::Course kFar{{100, 10}, {0, 0.5}};

std::vector<core::PosedScan> with_misses(double p_miss, int clutter = 0) {
  core::Random random(7);
  return testing::scans_of({kFar}, 20, {0.0, 0.0, true, p_miss, clutter}, random);
}

TEST(CountDecision, ATargetThatIsAlwaysSeenIsEvident) {
  EXPECT_GT(Fitted(with_misses(0.0), kFar).evidence(), 50.0);
}

TEST(CountDecision, MissesAndClutterWeakenTheEvidence) {
  const double clean = Fitted(with_misses(0.0), kFar).evidence();
  const double missed = Fitted(with_misses(0.5), kFar).evidence();
  const double cluttered = Fitted(with_misses(0.0, 30), kFar).evidence();
  EXPECT_LT(missed, clean);
  EXPECT_LT(cluttered, clean);
}

// The same 20 detections, once 100 m ahead, once 2 m ahead: there a metre across is 30 degrees, clutter is as
// denser on the ground than anywhere else, and many detections in one place are weak evidence.
TEST(CountDecision, APileBesideTheSonarIsWeakEvidence) {
  const testing::Course near{{2, 0}, {0, 0}}, far{{100, 0}, {0, 0}};
  const double beside = Fitted(testing::scans_of({near}), near).evidence();
  const double ahead = Fitted(testing::scans_of({far}), far).evidence();
  EXPECT_LT(beside, ahead - 20.0);
}

// Five scans without an own detection: a foreign range in the target's beam speaks more against it than
// silence.
TEST(CountDecision, AForeignRangeInItsBeamSpeaksAgainstATarget) {
  auto silent = with_misses(0.0), foreign = with_misses(0.0);
  for (std::size_t k = 5; k < 10; ++k) {
    silent[k].scan.returns.clear();
    foreign[k].scan.returns.front().range = 30.0;
  }
  EXPECT_LT(Fitted(foreign, kFar).evidence(), Fitted(silent, kFar).evidence() - 1.0);
}

TEST(CountDecision, OfferedCandidatesNeedLess) {
  CountDecision decision({});
  Candidate candidate;
  candidate.support = 4;
  candidate.log_evidence = -1.0;
  EXPECT_FALSE(decision.accepts(candidate, 0));
  candidate.offered = true;
  EXPECT_TRUE(decision.accepts(candidate, 0));
}

// A normal prior of 1 m/s in place of the disc of 5 m/s: its density at the fit's speed v is
// exp(-v^2 / 2) / (2 pi) against 1 / (25 pi).
TEST(CountDecision, ANormalVelocityPriorReplacesTheDisc) {
  const Fitted target(with_misses(0.0), kFar);
  CountDecisionParams normal;
  normal.velocity_sigma = 1.0;
  const double v2 = target.candidate.state.tail<2>().squaredNorm();
  EXPECT_NEAR(target.evidence(normal) - target.evidence(), std::log(25.0 / 2.0) - 0.5 * v2, 1e-9);
}

TEST(CountDecision, AnOfferedCandidateIsNewOnlyOnItsOwnEvidence) {
  CountDecision decision({});
  Candidate candidate;
  candidate.support = 4;
  candidate.offered = true;
  candidate.log_evidence = -1.0;
  EXPECT_FALSE(decision.accepts_as_new(candidate, 0));
  candidate.log_evidence = 1.0;
  EXPECT_TRUE(decision.accepts_as_new(candidate, 0));
}

// .36 of 18 detections are 6.5: six are too few beside such a target, seven are enough.
TEST(CountDecision, SupportIsMeasuredAgainstTheBestTarget) {
  CountDecision decision({});
  Candidate candidate;
  candidate.log_evidence = 10.0;
  candidate.support = 6;
  EXPECT_FALSE(decision.accepts(candidate, 18));
  candidate.support = 7;
  EXPECT_TRUE(decision.accepts(candidate, 18));
}

TEST(CountDecision, RefusesNonsense) {
  CountDecisionParams params;
  params.edge = 0.7;
  EXPECT_THROW(CountDecision{params}, std::invalid_argument);
}

// Log odds ln 3 are a probability of 3/4; an offered candidate at its limit of -3 is as likely as not.
TEST(CountDecision, ExistenceIsTheEvidenceAsAProbability) {
  Candidate candidate;
  candidate.log_evidence = std::log(3.0);
  EXPECT_DOUBLE_EQ(existence_of(candidate, {}), 0.75);
  candidate.offered = true;
  candidate.log_evidence = -3.0;
  EXPECT_DOUBLE_EQ(existence_of(candidate, {}), 0.5);
}

}  // namespace
}  // namespace lookout::csht
