#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
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

/// The parameters of each.
template <class Tracker>
struct ParamsOf;
template <>
struct ParamsOf<JipdaTracker> {
  using Type = JipdaParams;
};
template <>
struct ParamsOf<PmbmTracker> {
  using Type = PmbmParams;
};
template <>
struct ParamsOf<GmPhdTracker> {
  using Type = GmPhdParams;
};

/// What a tracker with so many models of motion makes of a target that turns by 90 degrees at 2 m/s.
struct Turn {
  std::set<std::int64_t> ids;  ///< Identities that it had.
  double worst = 0.0;          ///< Largest error of a report from the 10th scan on [m].
};

/// @param rate of the turn [degrees a scan].
template <class Tracker>
Turn turn(int models, double rate) {
  constexpr int kScans = 80, kSettled = 10, kBegin = 30;
  typename ParamsOf<Tracker>::Type params;
  params.motion.models = models;
  Tracker tracker(params, known_sonar(0.1, 0.05));
  Turn result;
  Eigen::Vector2d at(60.0, 0.0);
  for (int k = 0; k < kScans; ++k) {
    for (const core::Track& track : confirmed(tracker.update(scan_of(k, {at}), {}))) {
      if (k < kSettled) continue;
      result.ids.insert(track.id);
      result.worst = std::max(result.worst, (track.position() - at).norm());
    }
    const double course = core::radians(std::clamp(rate * (k - kBegin + 1), 0.0, 90.0));
    at += Eigen::Vector2d(std::cos(course), std::sin(course));
  }
  return result;
}

constexpr double kNineDegreesASecond = 4.5;  // [degrees a scan]
constexpr double kAtOnce = 90.0;

TYPED_TEST(Rival, InteractingModelsHoldATurn) {
  const Turn two = turn<TypeParam>(2, kNineDegreesASecond), one = turn<TypeParam>(1, kNineDegreesASecond);
  EXPECT_EQ(two.ids.size(), 1U);
  EXPECT_LT(two.worst, 3.0);  // the sensor's range sigma
  EXPECT_GT(one.ids.size(), 1U);
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
  const auto sure = tracks_through_clutter(tracker);
  ASSERT_EQ(sure.size(), 1U);
  EXPECT_GT(sure[0].existence, 0.9);
  EXPECT_NEAR(sure[0].state(0), 50.0 + 0.5 * 59, 1.0);
  EXPECT_NEAR(sure[0].state(2), 1.0, 0.2);
}

TYPED_TEST(BernoulliRival, InteractingModelsHoldATurnAtOnce) {
  EXPECT_EQ(turn<TypeParam>(2, kAtOnce).ids.size(), 1U);
  EXPECT_GT(turn<TypeParam>(1, kAtOnce).ids.size(), 1U);
}

TYPED_TEST(BernoulliRival, ClutterAloneConfirmsNothing) {
  TypeParam tracker({}, known_sonar(0.3, 0.1));
  core::Random random(6);
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(confirmed(tracker.update(cluttered(k, {}, 0.0, random), {})).empty()) << k;
}

}  // namespace
}  // namespace lookout::tracking
