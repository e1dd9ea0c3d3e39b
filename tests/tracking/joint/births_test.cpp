#include "tracking/joint/births.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/tracking/joint/track_scenes.hpp"

namespace lookout::tracking {
namespace {

std::vector<const csht::TargetTrack*> used(const TrackerState& state) {
  std::vector<const csht::TargetTrack*> result;
  for (const csht::TargetTrack& track : state.tracks)
    if (track.used) result.push_back(&track);
  return result;
}

// Where `push_target` has its target in the eighth scan.
core::MotionElement element_on_target() {
  core::MotionElement element;
  element.position = {63.5, 10.0};
  element.velocity = {1.0, 0.0};
  element.covariance = Eigen::Matrix4d::Identity();
  return element;
}

TEST(Births, AnElementOfAnotherEstimatorIsWeighedUnderTheLikelihood) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  core::MotionElement nothing_there = element_on_target();
  nothing_there.position = {120.0, -60.0};
  Births births({}, nullptr);
  births.begin(scan_of(7, {}), std::vector{nothing_there, element_on_target()}, state);
  ASSERT_EQ(used(state).size(), 1U);
  EXPECT_NEAR(used(state)[0]->moments.mean[0], 63.5, 1.5);
  EXPECT_GT(used(state)[0]->existence(), 0.9);
}

TEST(Births, WhatTheEngineFoundInTheSceneIsAdoptedAsItIs) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  std::vector<std::int64_t> begun;
  state.log = [&begun](const TrackDecision& decision) { begun.push_back(decision.track); };
  core::MotionElement element;
  element.hypothesis = state.slot_of(add_track(state, {63.5, 10.0, 1.0, 0.0}, 1.5));
  Births({}, nullptr).begin(scan_of(7, {}), {&element, 1}, state);
  ASSERT_EQ(used(state).size(), 1U);
  EXPECT_DOUBLE_EQ(used(state)[0]->log_odds, 1.5);
  EXPECT_EQ(begun, std::vector<std::int64_t>{used(state)[0]->id});
}

/// Proposes one element, and notes which tracks it was told of.
class OneProposal : public BirthMethod {
 public:
  explicit OneProposal(std::size_t& told) : told_(told), element_(element_on_target()) {}
  std::span<const core::MotionElement> propose(const core::PosedScan& /*scan*/,
                                               std::span<const core::Track> tracks) override {
    told_ = tracks.size();
    return {&element_, 1};
  }

 private:
  std::size_t& told_;
  core::MotionElement element_;
};

TEST(Births, AProposalTakesThePlaceOfElementsAndIsToldOfTheTracks) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 8);
  std::size_t told = 99;
  Births births({}, std::make_unique<OneProposal>(told));
  EXPECT_FALSE(births.takes_elements());
  births.begin(scan_of(7, {}), {}, state);
  EXPECT_EQ(told, 0U);
  ASSERT_EQ(used(state).size(), 1U);
  births.begin(scan_of(7, {}), {}, state);
  EXPECT_EQ(told, 1U);
  EXPECT_EQ(used(state).size(), 1U);  // Known by now.
}

}  // namespace
}  // namespace lookout::tracking
