#include <gtest/gtest.h>

#include <string>

#include "tests/tracking/baselines/rival_scans.hpp"
#include "tracking/baselines/gm_phd/gm_phd_tracker.hpp"
#include "tracking/baselines/jipda/jipda_tracker.hpp"
#include "tracking/baselines/pmbm/pmbm_tracker.hpp"

namespace lookout::tracking {
namespace {

/// What every rival of the literature must do.
template <class Tracker>
class Rival : public ::testing::Test {};
using Rivals = ::testing::Types<JipdaTracker, PmbmTracker, GmPhdTracker>;
TYPED_TEST_SUITE(Rival, Rivals);

TYPED_TEST(Rival, CrossingTargetsKeepTheirIdentities) {
  TypeParam tracker({}, known_sonar(0.1, 0.05));
  EXPECT_TRUE(crossing_targets_keep_their_identities(tracker));
}

TYPED_TEST(Rival, ALostTargetEnds) {
  TypeParam tracker({}, known_sonar(0.1, 0.05));
  for (int k = 0; k < 20; ++k) tracker.update(scan_of(k, {{60.0, 0.0}}), {});
  std::span<const core::Track> tracks;
  for (int k = 20; k < 40; ++k) tracks = tracker.update(scan_of(k, {}), {});
  EXPECT_TRUE(confirmed(tracks).empty());
}

TYPED_TEST(Rival, TellsBeginningConfirmationAndEnd) {
  TypeParam tracker({}, known_sonar(0.1, 0.05));
  ASSERT_TRUE(tracker.explains());
  std::string told;
  tracker.explain_to([&told](const TrackDecision& decision) {
    EXPECT_STRNE(decision.reason, "");
    if (decision.track == 1) told += std::string(to_string(decision.kind)) + " ";
  });
  for (int k = 0; k < 20; ++k) tracker.update(scan_of(k, {{60.0, 0.0}}), {});
  for (int k = 20; k < 40; ++k) tracker.update(scan_of(k, {}), {});
  EXPECT_EQ(told, "begin confirm end ");
}

TYPED_TEST(Rival, IdentitiesGoOn) {
  TypeParam tracker({}, known_sonar(0.1, 0.05));
  tracker.set_next_id(100);
  const auto tracks = tracker.update(scan_of(0, {{60.0, 0.0}}), {});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 100);
  EXPECT_EQ(tracker.next_id(), 101);
}

/// What those must do that give each target an existence of its own.
template <class Tracker>
class BernoulliRival : public ::testing::Test {};
using BernoulliRivals = ::testing::Types<JipdaTracker, PmbmTracker>;
TYPED_TEST_SUITE(BernoulliRival, BernoulliRivals);

TYPED_TEST(BernoulliRival, FollowsATargetThroughClutterAndMisses) {
  TypeParam tracker({}, known_sonar(0.3, 0.1));
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

TYPED_TEST(BernoulliRival, ClutterAloneConfirmsNothing) {
  TypeParam tracker({}, known_sonar(0.3, 0.1));
  core::Random random(6);
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(confirmed(tracker.update(cluttered(k, {}, 0.0, random), {})).empty()) << k;
}

}  // namespace
}  // namespace lookout::tracking
