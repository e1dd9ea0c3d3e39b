#include "fusion/node_credit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/random.hpp"
#include "fusion/fusion.hpp"
#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::estimate;

TEST(NodeCredit, FollowsWhatTheTracksCameTo) {
  NodeCredit credit({}, 0.9);
  EXPECT_EQ(credit.of(1), 0.9);
  credit.note_begun(1);
  credit.note_false(1);
  EXPECT_DOUBLE_EQ(credit.of(1), 9.0 / 11.0);  // A prior of ten tracks, nine of them true.
  credit.note_begun(1);
  credit.note_proved(1);
  EXPECT_DOUBLE_EQ(credit.of(1), 10.0 / 12.0);
  for (int k = 0; k < 40; ++k) credit.note_proved(1);
  EXPECT_EQ(credit.of(1), 0.9);  // No more than the trust that everyone begins with.
  EXPECT_EQ(credit.of(2), 0.9);
}

TEST(NodeCredit, ANodeThatErredBeginsTracksAgainOnceItIsMended) {
  NodeCredit credit({}, 0.9);
  for (int k = 0; k < 100; ++k) credit.note_false(1);
  EXPECT_FALSE(credit.may_begin(1, 9.9));
  EXPECT_TRUE(credit.may_begin(1, 10.0));  // What has lasted for ten seconds is believed of anyone.
  int proved = 0;
  for (; !credit.may_begin(1, 0.0); ++proved) credit.note_proved(1);
  EXPECT_GT(proved, 10);
  EXPECT_LT(proved, 50);  // The memory: 50 outcomes.
}

TEST(NodeCredit, LimitsHowManyTracksAreUnprovedAtOneTime) {
  NodeCreditParams params;
  params.max_unproved = 2;
  NodeCredit credit(params, 0.9);
  credit.note_begun(1);
  EXPECT_TRUE(credit.may_begin(1, 0.0));
  credit.note_begun(1);
  EXPECT_FALSE(credit.may_begin(1, 0.0));
  EXPECT_TRUE(credit.may_begin(2, 0.0));
  credit.note_undecided(1);
  EXPECT_TRUE(credit.may_begin(1, 0.0));
  EXPECT_EQ(credit.of(1), 0.9);  // A track that became one with another says nothing.
}

TEST(NodeCredit, ForgetsTheNodeItKnowsLeastOf) {
  NodeCredit credit({}, 0.9);
  for (int k = 0; k < 3; ++k) credit.note_false(-1);
  for (std::int32_t node = 0; node < 1000; ++node) credit.note_false(node);
  EXPECT_LT(credit.of(-1), 0.8);
  EXPECT_EQ(credit.of(500), 0.9);
}

TEST(NodeCredit, RefusesBadParameters) {
  NodeCreditParams params;
  params.least = 1.5;
  EXPECT_THROW(NodeCredit(params, 0.9), std::invalid_argument);
  params = {};
  params.max_unproved = 0;
  EXPECT_THROW(NodeCredit(params, 0.9), std::invalid_argument);
}

/// Node 1 follows one target for a minute. Node 2, two kilometres off, sends a new track twice a second, each
/// twice, at places drawn at random.
class AnInventor : public ::testing::Test {
 protected:
  void run(double begin, double end) {
    for (double time = begin; time < end; time += 0.5) {
      fusion.add(estimate(1, 1, time, {2.0 * time, 0, 2, 0}));
      Eigen::Vector4d state{2000.0 + random.uniform(0.0, 1000.0), random.uniform(-500.0, 500.0), 1, 0};
      fusion.add(estimate(2, ++invented, time - 0.4, state));
      fusion.add(estimate(2, invented, time, core::moved(state, 0.4)));
      update(time);
    }
  }
  void update(double time) {
    for (const core::Track& track : fusion.update(core::microseconds(time))) {
      if (track.state(0) > 1500.0) last_false = std::max(last_false, track.id);
      newest_existence = track.existence;
    }
  }

  Fusion fusion{FusionParams{}};
  core::Random random{3};
  std::int64_t invented = 0, last_false = 0;
  double newest_existence = 0.0;
};

TEST_F(AnInventor, LosesItsCreditAndTheOtherNodeKeepsIts) {
  run(0.0, 60.0);
  EXPECT_EQ(invented, 120);
  // Nine outcomes spend a prior of nine true in ten tracks down to one half; the next wait for theirs.
  EXPECT_LT(last_false, 20);
  EXPECT_LT(fusion.global_tracks().credit_of(2), 0.5);
  EXPECT_EQ(fusion.global_tracks().credit_of(1), 0.9);
  EXPECT_GT(fusion.global_tracks().refused_births(), 80);
}

TEST_F(AnInventor, HasTrueTracksInThePictureOnceTheyLast) {
  run(0.0, 30.0);
  last_false = 0;
  double shown_at = 0.0;
  for (double time = 30.0; time < 50.0; time += 0.5) {
    fusion.add(estimate(1, 1, time, {2.0 * time, 0, 2, 0}));
    fusion.add(estimate(2, 9999, time, {2000.0 + time, 0, 1, 0}));
    update(time);
    if (last_false > 0 && shown_at == 0.0) shown_at = time;
  }
  EXPECT_NEAR(shown_at, 40.0, 1.0);  // After the ten seconds that prove a track.
  EXPECT_LT(newest_existence, 0.6);  // On the word of a node that errs.
}

}  // namespace
}  // namespace lookout::fusion
