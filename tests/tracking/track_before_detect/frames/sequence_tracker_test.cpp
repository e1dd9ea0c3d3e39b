#include "tracking/track_before_detect/frames/sequence_tracker.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

constexpr double kStep = 1.0;

TEST(SequenceTracker, AGivenStartIsTrackOneFromTheFirstFrame) {
  core::Random random(1004);
  TbdParams params;
  params.start = Eigen::Vector4d(29.0, 40.0, 1.0, 0.0);
  params.target_area = 15.0;
  SequenceTracker tracker("i_h_pmht_4", params);
  ASSERT_EQ(tracker.batch_length(), 1);
  for (int k = 0; k < 10; ++k) {
    const IntensityFrame frame = blobs({{30.0 + k, 40.0}}, 20.0, random);
    const auto& tracks = tracker.process({&frame, 1}, {&kStep, 1});
    ASSERT_EQ(tracks[0].size(), 1u);
    EXPECT_EQ(tracks[0][0].id, 1);
    EXPECT_LT((tracks[0][0].state.head<2>() - Eigen::Vector2d(30.0 + k, 40.0)).norm(), 1.0) << k;
  }
}

TEST(SequenceTracker, WithoutAStartItFindsTheTargetAndEndsWhatItStartsBesideIt) {
  core::Random random(1005);
  TbdParams params;
  params.target_area = 15.0;
  SequenceTracker tracker("i_h_pmht_4", params);
  std::vector<FrameTrack> last;
  for (int k = 0; k < 40; ++k) {
    const IntensityFrame frame = blobs({{30.0 + k, 40.0}}, 8.0, random);
    last = tracker.process({&frame, 1}, {&kStep, 1})[0];
  }
  ASSERT_EQ(last.size(), 1u);
  EXPECT_LT((last[0].state.head<2>() - Eigen::Vector2d(69.0, 40.0)).norm(), 1.5);
  EXPECT_GT(last[0].existence, 0.9);
}

// In intensities that hold nothing the method has nothing to go by: the spot of the grey levels is reported.
TEST(SequenceTracker, WhereTheMethodDepartsTheSpotCounts) {
  core::Random random(1006);
  SequenceTracker tracker("i_h_pmht_4", {});
  std::vector<FrameTrack> last;
  for (int k = 0; k < 12; ++k) {
    const IntensityFrame bright = blobs({{30.0 + k, 40.0}}, 20.0, random), nothing = blobs({}, 0.0, random);
    last = tracker.process({&nothing, 1}, {&kStep, 1}, {&bright.values, 1})[0];
  }
  ASSERT_EQ(last.size(), 1u);
  EXPECT_LT((last[0].state.head<2>() - Eigen::Vector2d(41.0, 40.0)).norm(), 3.0);
}

TEST(SequenceTracker, TheSignatureFollowsTheArea) {
  TbdParams params;
  params.target_area = 4.0 * M_PI * 9.0;  // A disc of variance 9 along each axis.
  EXPECT_NEAR(pixel_tracker_params(params).scales.filter.sigma.x(), 3.0, 1e-12);
  params.target_area = 0.1;  // A point still fills about a pixel.
  EXPECT_NEAR(pixel_tracker_params(params).scales.filter.sigma.x(), 0.75, 1e-12);
}

TEST(SequenceTracker, RefusesAnUnknownMethod) {
  EXPECT_THROW(SequenceTracker("kalman", {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
