#include "tools/cli/logs/replay_log.hpp"

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

TEST(NotesOf, SayWhatWasNotUsed) {
  LogFigures figures;
  core::Recording recording;
  EXPECT_TRUE(notes_of(figures, recording).empty());
  figures.refusals = {{"SONAR_SCAN", "too long", 3}};
  figures.is_fixed = true;
  recording.new_clocks.resize(1);
  const auto notes = notes_of(figures, recording);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0], "SONAR_SCAN: 3 messages refused: too long");
  EXPECT_TRUE(notes[2].starts_with("holds 2 clocks"));
}

}  // namespace
}  // namespace lookout::tools
