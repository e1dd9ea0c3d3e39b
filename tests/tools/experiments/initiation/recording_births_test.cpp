#include "tools/experiments/initiation/recording_births.hpp"

#include <gtest/gtest.h>

#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tools {
namespace {

TEST(RecordingBirths, EveryInitiatorOnEveryRecording) {
  const auto cells = make_recording_births()->cells();
  EXPECT_EQ(cells.size(), 4u * (tracking::initiator_names().size() + 1));  // And the tracker's own births.
}

TEST(RecordingBirths, FollowsABoatThatVctStarts) {
  const auto experiment = make_recording_births();
  if (!experiment->missing_input().empty()) GTEST_SKIP() << experiment->missing_input();
  for (const Cell& cell : experiment->cells()) {
    if (cell.method != "vct" || cell.parameters.number("scenario") != 2.0) continue;
    EXPECT_GT(experiment->run(cell, 1000, 0).at("followed_share").value, 0.5);
  }
}

}  // namespace
}  // namespace lookout::tools
