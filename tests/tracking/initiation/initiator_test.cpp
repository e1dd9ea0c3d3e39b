#include "tracking/initiation/initiator.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(StartedTracks, ATracksPlotsAreItsRunOfTheList) {
  StartedTracks started;
  started.plots = {4, 7, 9, 2, 5};
  StartedTrack track;
  track.first_plot = 3;
  track.num_plots = 2;
  EXPECT_EQ(started.plots_of(track)[0], 2);
  EXPECT_EQ(started.plots_of(track)[1], 5);
}

TEST(StartedTracks, ClearForgetsTheRefusalToo) {
  StartedTracks started;
  started.plots = started.survivors = {1};
  started.tracks.resize(1);
  started.refusal = "too much";
  started.clear();
  EXPECT_TRUE(started.plots.empty() && started.survivors.empty() && started.tracks.empty());
  EXPECT_TRUE(started.refusal.empty());
}

TEST(StartedTrack, LiesOnItsCourseAtItsFirstTime) {
  StartedTrack track;
  track.state << 10.0, 20.0, 2.0, -1.0;
  track.first_time = 1.0;
  track.last_time = 4.0;
  EXPECT_EQ(track.initial_position(), Eigen::Vector2d(4.0, 23.0));  // Three seconds back.
}

}  // namespace
}  // namespace lookout::tracking
