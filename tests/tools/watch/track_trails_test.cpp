#include "tools/watch/track_trails.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

lcmtypes::KeyedTracks list_at(double seconds) {
  return {{core::microseconds(seconds), 0, 0}, {core::Track{}}};
}

TEST(TrackTrails, KeepsHalfAMinuteThinned) {
  TrackTrails trails;
  for (int k = 0; k <= 2000; ++k) trails.add(list_at(0.05 * k));  // 100 s at 20 Hz.
  EXPECT_EQ(trails.lists().back().key.utime, 100'000'000);
  EXPECT_GE(trails.lists().front().key.utime, 70'000'000);
  EXPECT_LE(trails.lists().size(), 30.0 / 0.4 + 2);  // Every 0.4 s: the last step of 20 Hz within kSpacing.
  EXPECT_GE(trails.lists().size(), 50u);
}

TEST(TrackTrails, KeepsEveryListOfASlowSonar) {
  TrackTrails trails;
  for (int k = 0; k < 5; ++k) trails.add(list_at(6.0 * k));
  EXPECT_EQ(trails.lists().size(), 5u);
}

TEST(TrackTrails, BeginsAnewWhereTheClockGoesBack) {
  TrackTrails trails;
  trails.add(list_at(50.0));
  trails.add(list_at(1.0));
  EXPECT_EQ(trails.lists().size(), 1u);
}

}  // namespace
}  // namespace lookout::tools
