#include "tracking/restart/identity_map.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// Known to a metre and to 0.1 m/s.
core::Track track(std::int64_t id, double north, double velocity = 0.0,
                  core::TrackStatus status = core::TrackStatus::confirmed) {
  core::Track track;
  track.id = id;
  track.status = status;
  track.state << north, 0.0, velocity, 0.0;
  track.covariance.diagonal() << 1.0, 1.0, 0.01, 0.01;
  track.first_utime = id;
  return track;
}

std::vector<std::int64_t> ids(std::span<const core::Track> tracks) {
  std::vector<std::int64_t> all;
  for (const auto& one : tracks) all.push_back(one.id);
  return all;
}

using Ids = std::vector<std::int64_t>;

TEST(IdentityMap, ChangesNothingWithoutARestart) {
  IdentityMap map;
  const std::vector tracks{track(1, 0.0)};
  EXPECT_EQ(map.rename(tracks, 0).data(), tracks.data());
  EXPECT_EQ(map.outside(1), 1);
}

TEST(IdentityMap, GivesIdentitiesBackByWhereTracksMustBe) {
  IdentityMap map;
  map.expect(std::vector{track(7, 0.0, 2.0), track(8, 50.0)}, 0);
  // After 5 s the first must be at 10 m.
  EXPECT_EQ(ids(map.rename(std::vector{track(101, 50.5), track(102, 11.0)}, 5 * kSecond)), (Ids{8, 7}));
  EXPECT_EQ(map.num_expected(), 0u);
  EXPECT_EQ(map.outside(102), 7);
  // And they keep them, wherever they go.
  EXPECT_EQ(ids(map.rename(std::vector{track(102, 500.0)}, 90 * kSecond)), Ids{7});
  EXPECT_EQ(map.rename(std::vector{track(102, 500.0)}, 90 * kSecond)[0].first_utime, 7);
}

TEST(IdentityMap, OfTwoThatAreNearTheNearestPairComesFirst) {
  IdentityMap map;
  map.expect(std::vector{track(7, 0.0), track(8, 3.0)}, 0);
  EXPECT_EQ(ids(map.rename(std::vector{track(101, 2.9), track(102, 1.0)}, 0)), (Ids{8, 7}));
}

TEST(IdentityMap, AStrangerStaysOneAndATentativeTrackWaits) {
  IdentityMap map;
  map.expect(std::vector{track(7, 0.0)}, 0);
  EXPECT_EQ(
      ids(map.rename(std::vector{track(101, 100.0), track(102, 0.0, 0.0, core::TrackStatus::tentative)}, 0)),
      (Ids{101, 102}));
  EXPECT_EQ(ids(map.rename(std::vector{track(101, 0.0), track(102, 0.5)}, kSecond)), (Ids{101, 7}));
}

TEST(IdentityMap, LooksForAWhileAndNotOnANewClock) {
  IdentityMap map;
  map.expect(std::vector{track(7, 0.0)}, 0);
  EXPECT_EQ(ids(map.rename(std::vector{track(101, 0.0)}, 20 * kSecond)), Ids{101});
  map.expect(std::vector{track(7, 0.0)}, 0);
  map.stop_looking();
  EXPECT_EQ(ids(map.rename(std::vector{track(103, 0.0)}, 0)), Ids{103});
}

}  // namespace
}  // namespace lookout::tracking
