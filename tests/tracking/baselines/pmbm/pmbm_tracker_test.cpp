#include "tracking/baselines/pmbm/pmbm_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tracking/baselines/rival_scans.hpp"

namespace lookout::tracking {
namespace {

TEST(PmbmTracker, FollowsATargetThroughClutterAndMisses) {
  PmbmTracker tracker({}, known_sonar(0.3, 0.1));
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

TEST(PmbmTracker, ClutterAloneConfirmsNothing) {
  PmbmTracker tracker({}, known_sonar(0.3, 0.1));
  core::Random random(6);
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(confirmed(tracker.update(cluttered(k, {}, 0.0, random), {})).empty()) << k;
}

TEST(PmbmTracker, CrossingTargetsKeepTheirIdentities) {
  PmbmTracker tracker({}, known_sonar(0.1, 0.05));
  EXPECT_TRUE(crossing_targets_keep_their_identities(tracker));
}

TEST(PmbmTracker, ALostTargetEnds) {
  PmbmTracker tracker({}, known_sonar(0.1, 0.05));
  for (int k = 0; k < 20; ++k) tracker.update(scan_of(k, {{60.0, 0.0}}), {});
  std::span<const core::Track> tracks;
  for (int k = 20; k < 40; ++k) tracks = tracker.update(scan_of(k, {}), {});
  EXPECT_TRUE(confirmed(tracks).empty());
}

TEST(PmbmTracker, IdentitiesGoOn) {
  PmbmTracker tracker({}, known_sonar(0.1, 0.05));
  tracker.set_next_id(100);
  const auto tracks = tracker.update(scan_of(0, {{60.0, 0.0}}), {});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 100);
  EXPECT_EQ(tracker.next_id(), 101);
}

TEST(PmbmTracker, RefusesParametersOutOfRange) {
  PmbmParams params;
  params.promote = 1.0;
  EXPECT_THROW(PmbmTracker(params, {}), std::invalid_argument);
  params = {};
  params.demote = 0.9;
  EXPECT_THROW(PmbmTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
