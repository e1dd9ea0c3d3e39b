#include "tracking/joint/births.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/tracking/joint/joint_scenes.hpp"

namespace lookout::tracking {
namespace {

std::vector<const csht::TargetTrack*> used(const TrackerState& state) {
  std::vector<const csht::TargetTrack*> result;
  for (const csht::TargetTrack& track : state.tracks)
    if (track.used) result.push_back(&track);
  return result;
}

TEST(Births, EightEchoesOfOneTargetAreOneSureTrack) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  Births onset({}, csht::TargetPrior(), nullptr);
  onset.begin(scan_of(7, {}), state);
  const auto tracks = used(state);
  ASSERT_FALSE(tracks.empty());
  const auto best = *std::max_element(tracks.begin(), tracks.end(),
                                      [](auto* a, auto* b) { return a->log_odds < b->log_odds; });
  EXPECT_NEAR(best->moments.mean[0], 63.5, 1.5);
  EXPECT_GT(best->existence(), 0.9);
}

TEST(Births, BeginsNoSecondTrackOnAKnownTarget) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  Births onset({}, csht::TargetPrior(), nullptr);
  onset.begin(scan_of(7, {}), state);
  const std::size_t before = used(state).size();
  onset.begin(scan_of(7, {}), state);
  EXPECT_LE(used(state).size(), before);
}

TEST(Births, OneEchoIsNoTrack) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 1);
  Births({}, csht::TargetPrior(), nullptr).begin(scan_of(0, {}), state);
  EXPECT_TRUE(used(state).empty());
}

/// Proposes one element, and notes which tracks it was told of.
class OneProposal : public BirthMethod {
 public:
  explicit OneProposal(std::size_t& told) : told_(told) {
    element_.position = {63.5, 10.0};
    element_.velocity = {1.0, 0.0};
    element_.covariance = Eigen::Matrix4d::Identity();
  }
  std::span<const core::MotionElement> propose(const core::PosedScan& /*scan*/,
                                               std::span<const core::Track> tracks) override {
    told_ = tracks.size();
    return {&element_, 1};
  }

 private:
  std::size_t& told_;
  core::MotionElement element_;
};

TEST(Births, AProposalIsWeighedLikeASeedOfItsOwn) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  std::size_t told = 99;
  Births onset({}, csht::TargetPrior(), std::make_unique<OneProposal>(told));
  onset.begin(scan_of(7, {}), state);
  EXPECT_EQ(told, 0U);
  ASSERT_EQ(used(state).size(), 1U);
  EXPECT_GT(used(state)[0]->existence(), 0.9);
  onset.begin(scan_of(7, {}), state);
  EXPECT_EQ(told, 1U);
  EXPECT_EQ(used(state).size(), 1U);
}

}  // namespace
}  // namespace lookout::tracking
