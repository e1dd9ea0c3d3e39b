#include "tracking/track_before_detect/frames/gated_centroid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

constexpr double kStep = 1.0;

std::unique_ptr<FrameTracker> started(const Eigen::Vector4d& state) {
  GatedCentroidParams params;
  params.target_area = 12.0;
  auto tracker = make_gated_centroid(params);
  tracker->add(7, state, Eigen::Matrix4d::Identity());
  return tracker;
}

TEST(GatedCentroid, FollowsABlobFromAStartThatIsOff) {
  core::Random random(1000);
  const auto tracker = started({19.0, 41.0, 1.0, 0.0});
  FrameTrack last;
  for (int t = 1; t <= 20; ++t) {
    const IntensityFrame frame = blobs({{20.0 + 1.5 * t, 40.0}}, 12.0, random);
    last = tracker->process({&frame, 1}, {&kStep, 1}).at(0).at(0);
  }
  EXPECT_EQ(last.id, 7);
  EXPECT_NEAR(last.state[0], 50.0, 0.5);
  EXPECT_NEAR(last.state[1], 40.0, 0.5);
  EXPECT_NEAR(last.state[2], 1.5, 0.4);
}

TEST(GatedCentroid, ADarkFrameLeavesThePrediction) {
  const auto tracker = started({20.0, 40.0, 1.5, 0.0});
  const IntensityFrame dark{120, 80, std::vector<double>(9600, 0.0)};
  const FrameTrack track = tracker->process({&dark, 1}, {&kStep, 1}).at(0).at(0);
  EXPECT_EQ(track.state, Eigen::Vector4d(21.5, 40.0, 1.5, 0.0));
}

TEST(GatedCentroid, ATargetThatLeavesTheFrameIsLostAndOneRemovedIsGone) {
  const auto tracker = started({119.5, 40.0, 2.0, 0.0});
  const IntensityFrame dark{120, 80, std::vector<double>(9600, 0.0)};
  EXPECT_TRUE(tracker->process({&dark, 1}, {&kStep, 1}).at(0).at(0).lost);
  tracker->remove(7);
  EXPECT_TRUE(tracker->process({&dark, 1}, {&kStep, 1}).at(0).empty());
}

TEST(GatedCentroid, RefusesParametersOutOfRange) {
  GatedCentroidParams params;
  params.iterations = 0;
  EXPECT_THROW(make_gated_centroid(params), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
