#include "tracking/metrics/trajectory_gospa.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "tests/tracking/metrics/trajectory_examples.hpp"

namespace lookout::tracking {
namespace {

using tests::trajectories;

const TrajectorySet kTarget = trajectories({{1, {0, 0}, 0, 9}}, 10);

TEST(TrajectoryGospa, EqualSetsCostNothing) {
  const auto set = trajectories({{1, {0, 0}, 0, 9}, {2, {50, 0}, 3, 6}}, 10);
  EXPECT_EQ(TrajectoryGospa()(set, set).total, 0.0);
  EXPECT_EQ(TrajectoryGospa()({}, {}).total, 0.0);
}

// Ten times 3 m: total^2 = 10 x 9.
TEST(TrajectoryGospa, LocalizationAddsUpOverTheTimes) {
  const auto result = TrajectoryGospa()(kTarget, trajectories({{9, {3, 0}, 0, 9}}, 10));
  EXPECT_NEAR(result.total, std::sqrt(90.0), 1e-12);
  EXPECT_NEAR(result.localization, result.total, 1e-12);
}

// Four misses and three false tracks at 20^2 / 2 each; nothing for being late: the pair may stand from the
// start.
TEST(TrajectoryGospa, MissedAndFalseCostHalfTheCutoffEach) {
  const auto result = TrajectoryGospa()(kTarget, trajectories({{9, {0, 0}, 4, 9}, {8, {90, 0}, 0, 2}}, 10));
  EXPECT_NEAR(result.total, std::sqrt(7.0 * 200.0), 1e-9);
  EXPECT_NEAR(result.missed, std::sqrt(4.0 * 200.0), 1e-9);
  EXPECT_NEAR(result.false_tracks, std::sqrt(3.0 * 200.0), 1e-9);
  EXPECT_EQ(result.num_switches, 0.0);
}

TEST(TrajectoryGospa, ABrokenTrackCostsOneSwitch) {
  const auto result = TrajectoryGospa({.switch_penalty = 5.0})(
      kTarget, trajectories({{8, {0, 0}, 0, 4}, {9, {0, 0}, 5, 9}}, 10));
  EXPECT_NEAR(result.total, 5.0, 1e-12);
  EXPECT_NEAR(result.switches, 5.0, 1e-12);
  EXPECT_EQ(result.steps[5].switches, 1.0);
}

// Two targets, two tracks that change places: two switches, total^2 = 2 x 5^2. At a price above what misses
// cost the pairs are kept instead: two times two misses and false tracks, 4 x 2 x 20^2 / 2.
TEST(TrajectoryGospa, ASwapOfIdentitiesCostsTwoSwitchesUnlessKeepingIsCheaper) {
  const auto truth = trajectories({{1, {0, 0}, 0, 9}, {2, {100, 0}, 0, 9}}, 10);
  const auto swapped =
      trajectories({{8, {0, 0}, 0, 7}, {8, {100, 0}, 8, 9}, {9, {100, 0}, 0, 7}, {9, {0, 0}, 8, 9}}, 10);
  EXPECT_NEAR(TrajectoryGospa({.switch_penalty = 5.0})(truth, swapped).total, std::sqrt(50.0), 1e-9);
  EXPECT_NEAR(TrajectoryGospa({.switch_penalty = 1e3})(truth, swapped).total, std::sqrt(1600.0), 1e-9);
}

/// All pairings of two targets with two tracks, as the track of each target.
constexpr std::array<std::array<int, 2>, 7> kPairings{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 0}}};

/// The definition, for three times, two targets and two tracks: the least over all sequences of pairings, any
/// of them to begin with.
double by_definition(const TrajectorySet& truth, const TrajectorySet& estimate,
                     const TrajectoryGospaParams& params) {
  const auto at = [](const TrajectorySet& set, int id, std::size_t time) {
    const auto found = set.by_id().find(id);
    return found == set.by_id().end() ? std::nullopt : TrajectorySet::at(found->second, time);
  };
  const double limit = std::pow(params.cutoff, params.order);
  const auto cost = [&](const std::array<int, 2>& pairing, std::size_t time) {
    double sum = 0.0;
    for (int j = 0; j < 2; ++j) sum += at(estimate, j, time) ? 0.5 * limit : 0.0;
    for (int i = 0; i < 2; ++i) {
      const auto target = at(truth, i, time);
      if (!target) continue;
      const int j = pairing[static_cast<std::size_t>(i)];
      const auto track = j >= 0 ? at(estimate, j, time) : std::nullopt;
      sum += 0.5 * limit;
      if (track) sum += std::min(limit, std::pow((*target - *track).norm(), params.order)) - limit;
    }
    return sum;
  };
  const auto change = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
    double halves = 0.0;
    for (std::size_t i = 0; i < 2; ++i) halves += a[i] == b[i] ? 0.0 : (a[i] >= 0) + (b[i] >= 0);
    return 0.5 * halves * std::pow(params.switch_penalty, params.order);
  };
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : kPairings)
    for (const auto& b : kPairings)
      for (const auto& c : kPairings)
        least = std::min(least, cost(a, 0) + cost(b, 1) + cost(c, 2) + change(a, b) + change(b, c));
  return std::pow(least, 1.0 / params.order);
}

TEST(TrajectoryGospa, IsTheLeastOverAllSequencesOfPairings) {
  core::Random random(3);
  const auto draw = [&random](int id_base) {
    TrajectorySet set;
    for (int time = 0; time < 3; ++time) {
      set.next_time();
      for (int id = 0; id < 2; ++id)
        if (random.uniform(0.0, 1.0) < 0.7) set.add(id_base + id, {random.uniform(0.0, 25.0), 0.0});
    }
    return set;
  };
  for (int round = 0; round < 300; ++round) {
    const TrajectoryGospaParams params{
        .cutoff = 20.0, .order = 1.0 + round % 2, .switch_penalty = 1.0 + round % 15};
    const auto truth = draw(0), estimate = draw(0);
    EXPECT_NEAR(TrajectoryGospa(params)(truth, estimate).total, by_definition(truth, estimate, params), 1e-9)
        << round;
  }
}

// Twelve targets and twelve tracks within the cut-off of one another: 10^11 pairings a time.
TEST(TrajectoryGospa, GivesUpWhereTheExactMetricIsOutOfReach) {
  std::vector<tests::Standing> crowd;
  for (int id = 0; id < 12; ++id) crowd.push_back({id, {1.0 * id, 0.0}, 0, 9});
  const auto set = trajectories(crowd, 10);
  EXPECT_THROW(TrajectoryGospa()(set, set), std::length_error);
}

// Fifty targets out of one another's reach are fifty groups.
TEST(TrajectoryGospa, ManyTargetsApartAreNoTrouble) {
  std::vector<tests::Standing> fleet, tracks;
  for (int id = 0; id < 50; ++id) {
    fleet.push_back({id, {100.0 * id, 0.0}, 0, 199});
    tracks.push_back({id, {100.0 * id + 3.0, 0.0}, 0, 199});
  }
  EXPECT_NEAR(TrajectoryGospa()(trajectories(fleet, 200), trajectories(tracks, 200)).total,
              3.0 * std::sqrt(50.0 * 200.0), 1e-9);
}

TEST(TrajectoryGospa, RefusesBadParams) {
  EXPECT_THROW(TrajectoryGospa({.cutoff = 0.0}), std::invalid_argument);
  EXPECT_THROW(TrajectoryGospa({.order = std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW(TrajectoryGospa({.switch_penalty = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
