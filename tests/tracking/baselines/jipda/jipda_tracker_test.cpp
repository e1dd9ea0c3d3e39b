#include "tracking/baselines/jipda/jipda_tracker.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "core/random.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

core::SonarParams known_sonar(double miss, double false_alarm) {
  core::SonarParams sonar;
  sonar.miss_probability = miss;
  sonar.false_alarm_probability = false_alarm;
  return sonar;
}

std::vector<core::Track> confirmed(std::span<const core::Track> tracks) {
  std::vector<core::Track> result;
  for (const auto& track : tracks)
    if (track.status != core::TrackStatus::tentative) result.push_back(track);
  return result;
}

/// Scan k of these targets, each seen with 1 - P_M, among false alarms.
core::PosedScan cluttered(int k, const std::vector<Eigen::Vector2d>& targets, double miss,
                          core::Random& random) {
  std::vector<Eigen::Vector2d> seen;
  for (const auto& target : targets)
    if (!random.bernoulli(miss)) seen.push_back(target);
  for (int left = random.poisson(8.0); left > 0; --left)
    seen.push_back(core::from_polar(random.uniform(1.0, 150.0), core::radians(random.uniform(-44.0, 44.0))));
  return scan_of(k, seen);
}

TEST(JipdaTracker, FollowsATargetThroughClutterAndMisses) {
  JipdaTracker tracker({}, known_sonar(0.3, 0.1));
  core::Random random(5);
  std::span<const core::Track> tracks;
  for (int k = 0; k < 60; ++k)
    tracks = tracker.update(cluttered(k, {{50.0 + 0.5 * k, 0.0}}, 0.3, random), {});
  const auto sure = confirmed(tracks);
  ASSERT_EQ(sure.size(), 1U);
  EXPECT_GT(sure[0].existence, 0.9);
  EXPECT_NEAR(sure[0].state(0), 50.0 + 0.5 * 59, 1.0);
  EXPECT_NEAR(sure[0].state(2), 1.0, 0.2);
}

TEST(JipdaTracker, ClutterAloneConfirmsNothing) {
  JipdaTracker tracker({}, known_sonar(0.3, 0.1));
  core::Random random(6);
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(confirmed(tracker.update(cluttered(k, {}, 0.0, random), {})).empty()) << k;
}

TEST(JipdaTracker, CrossingTargetsKeepTheirIdentities) {
  JipdaTracker tracker({}, known_sonar(0.1, 0.05));
  std::vector<core::Track> before, after;
  for (int k = 0; k < 80; ++k) {
    const double east = -20.0 + 0.5 * k;
    const auto tracks = tracker.update(scan_of(k, {{60.0 + 0.3 * k, east}, {84.0 - 0.3 * k, east}}), {});
    if (k == 25) before = confirmed(tracks);
    after = confirmed(tracks);
  }
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(before[i].id, after[i].id);
    EXPECT_GT(before[i].state(2) * after[i].state(2), 0.0);  // each goes on in its direction
  }
}

TEST(JipdaTracker, ALostTargetEnds) {
  JipdaTracker tracker({}, known_sonar(0.1, 0.05));
  for (int k = 0; k < 20; ++k) tracker.update(scan_of(k, {{60.0, 0.0}}), {});
  std::span<const core::Track> tracks;
  for (int k = 20; k < 40; ++k) tracks = tracker.update(scan_of(k, {}), {});
  EXPECT_TRUE(confirmed(tracks).empty());
}

TEST(JipdaTracker, IdentitiesGoOn) {
  JipdaTracker tracker({}, known_sonar(0.1, 0.05));
  tracker.set_next_id(100);
  const auto tracks = tracker.update(scan_of(0, {{60.0, 0.0}}), {});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 100);
  EXPECT_EQ(tracker.next_id(), 101);
}

TEST(JipdaTracker, TheManoeuvringModelHoldsATurn) {
  const auto identities = [](int models) {
    JipdaParams params;
    params.motion.models = models;
    JipdaTracker tracker(params, known_sonar(0.1, 0.05));
    std::set<std::int64_t> ids;
    for (int k = 0; k < 70; ++k) {  // turns by 90 degrees at 2 m/s
      const Eigen::Vector2d at(60.0 + 1.0 * std::min(k, 30), 1.0 * std::max(0, k - 30));
      for (const auto& track : confirmed(tracker.update(scan_of(k, {at}), {}))) ids.insert(track.id);
    }
    return ids.size();
  };
  EXPECT_EQ(identities(2), 1U);
  EXPECT_GT(identities(1), 1U);
}

TEST(JipdaTracker, RefusesParametersOutOfRange) {
  JipdaParams params;
  params.most_events = 0.0;
  EXPECT_THROW(JipdaTracker(params, {}), std::invalid_argument);
  params = {};
  params.existence.end = 0.9;
  EXPECT_THROW(JipdaTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
