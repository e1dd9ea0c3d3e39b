#include "csht/ownership.hpp"

#include <gtest/gtest.h>

#include "tests/csht/straight_scene.hpp"

namespace lookout::csht {
namespace {

Candidate candidate_of(const testing::Course& course, double epoch, double off = 0.0) {
  Candidate candidate;
  candidate.state << course.at(epoch) + Eigen::Vector2d(off, 0.0), course.velocity;
  return candidate;
}

HoughWindow window_of(const std::vector<testing::Course>& courses) {
  HoughWindow window(20, testing::sonar(), 0.2);
  for (const auto& scan : testing::scans_of(courses)) window.add(scan);
  return window;
}

TEST(Ownership, DuplicatesOfOneTargetBecomeOne) {
  const testing::Course course{{80, 10}, {-1, 2}};
  const auto window = window_of({course});
  Ownership ownership({}, {});
  ownership.start(window, 4.75);
  std::vector<Candidate> candidates{candidate_of(course, 4.75), candidate_of(course, 4.75, 1.0),
                                    candidate_of(course, 4.75, -1.0)};
  EXPECT_EQ(ownership.accept(candidates, window), 1);
  EXPECT_EQ(ownership.accepted()[0].support, 20);
}

// Two courses that cross at 4.75 s: every detection gets one owner, and each target keeps most of its own.
TEST(Ownership, CrossingTargetsShareNoSample) {
  const testing::Course a{{60, -9.5}, {0, 2}}, b{{69.5, 0}, {-2, 0}};
  const auto window = window_of({a, b});
  Ownership ownership({}, {});
  ownership.start(window, 4.75);
  std::vector<Candidate> candidates{candidate_of(a, 4.75), candidate_of(b, 4.75)};
  ASSERT_EQ(ownership.accept(candidates, window), 2);
  const auto& first = ownership.accepted()[0];
  const auto& second = ownership.accepted()[1];
  EXPECT_LE(first.support + second.support, 40);
  EXPECT_GE(second.support, 17);
  for (std::size_t s = 0; s < 20; ++s)
    EXPECT_FALSE(first.own[s] >= 0 && first.own[s] == second.own[s]) << "scan " << s;
}

// Twenty clean detections need no track to speak for them. With a threshold out of reach only the offer lets
// them pass, and the accepted candidate says so.
TEST(Ownership, RemembersWhoWasAcceptedOnlyBecauseATrackOfferedIt) {
  const testing::Course course{{80, 10}, {-1, 2}};
  const auto window = window_of({course});
  for (const double min_evidence : {0.5, 1e6}) {
    CountDecisionParams decision;
    decision.min_evidence = min_evidence;
    Ownership ownership({}, decision);
    ownership.start(window, 4.75);
    std::vector<Candidate> candidates{candidate_of(course, 4.75)};
    candidates[0].offered = true;
    ASSERT_EQ(ownership.accept(candidates, window), 1);
    EXPECT_EQ(ownership.accepted()[0].offered, min_evidence > 1.0);
  }
}

TEST(Ownership, StartFreesEverything) {
  const testing::Course course{{80, 10}, {-1, 2}};
  const auto window = window_of({course});
  Ownership ownership({}, {});
  for (int k = 0; k < 2; ++k) {
    ownership.start(window, 4.75);
    std::vector<Candidate> candidates{candidate_of(course, 4.75)};
    EXPECT_EQ(ownership.accept(candidates, window), 1);
    EXPECT_EQ(ownership.accepted().size(), 1U);
  }
}

}  // namespace
}  // namespace lookout::csht
