#include "tracking/baselines/gm_phd/gm_phd_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tracking/baselines/rival_scans.hpp"

namespace lookout::tracking {
namespace {

TEST(GmPhdTracker, FollowsATargetThroughClutterAndMisses) {
  GmPhdTracker tracker({}, known_sonar(0.3, 0.1));
  const auto sure = tracks_through_clutter(tracker);
  ASSERT_EQ(sure.size(), 1U);
  EXPECT_GT(sure[0].existence, 0.3);  // it may just have been missed, and an intensity forgets
  EXPECT_NEAR(sure[0].state(0), 50.0 + 0.5 * 59, 1.0);
  EXPECT_NEAR(sure[0].state(2), 1.0, 0.2);
}

TEST(GmPhdTracker, ClutterAloneConfirmsLittle) {
  GmPhdTracker tracker({}, known_sonar(0.3, 0.1));
  core::Random random(6);
  std::size_t false_tracks = 0;
  for (int k = 0; k < 100; ++k)
    false_tracks += confirmed(tracker.update(cluttered(k, {}, 0.0, random), {})).size();
  EXPECT_LT(false_tracks, 30U);  // of some 800 false returns
}

TEST(GmPhdTracker, RefusesParametersOutOfRange) {
  GmPhdParams params;
  params.intensity.most = 0;
  EXPECT_THROW(GmPhdTracker(params, {}), std::invalid_argument);
  params = {};
  params.existence.end = 0.9;
  EXPECT_THROW(GmPhdTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
