#include "tools/cli/replay_log.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

std::vector<core::TrackList> two_lists() {
  std::vector<core::TrackList> lists(2);
  lists[0].utime = 1;
  lists[1].utime = 2;
  lists[1].tracks.resize(1);
  return lists;
}

TEST(FirstDifference, IsNoneBetweenEqualRunsAndTheirBeginnings) {
  auto shorter = two_lists();
  shorter.pop_back();
  EXPECT_FALSE(first_difference(two_lists(), two_lists()));
  EXPECT_FALSE(first_difference(two_lists(), shorter));
}

TEST(FirstDifference, IsTheTimeOfTheFirstListThatDiffers) {
  auto other = two_lists();
  other[1].tracks[0].state[2] = 1e-300;
  EXPECT_EQ(first_difference(two_lists(), other), 2);
  other[0].tracks.resize(1);
  EXPECT_EQ(first_difference(two_lists(), other), 1);
}

}  // namespace
}  // namespace lookout::tools
