#include "tracking/baselines/jipda/jipda_tracker.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tests/tracking/baselines/rival_scans.hpp"

namespace lookout::tracking {
namespace {

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
  EXPECT_TRUE(crossing_targets_keep_their_identities(tracker));
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
