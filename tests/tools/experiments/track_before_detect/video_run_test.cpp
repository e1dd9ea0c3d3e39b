#include "tools/experiments/track_before_detect/video_run.hpp"

#include <gtest/gtest.h>

#include "tracking/track_before_detect/frames/gated_centroid.hpp"

namespace lookout::tools {
namespace {

constexpr std::uint64_t kSeed = 301;

TEST(VideoRun, ARunHasTwentyScansAndIsRepeatedByItsSeed) {
  const VideoRun video = make_video({4, false, false}, kSeed, 0);
  EXPECT_EQ(video.frames.size(), 20u);
  EXPECT_EQ(video.frames[0].columns, 200);
  EXPECT_EQ(video.start, make_video({4, false, false}, kSeed, 0).start);
  EXPECT_NE(video.start, make_video({4, false, false}, kSeed, 1).start);
}

// [Pakfiliz2018] Table 2, scenario 4: PDIM noise 0 dB, SNR 8.54 dB; the amplitude information of 5 x 5
// pixels, partly covered, lies below it.
TEST(VideoRun, LevelsAreThoseOfTable2) {
  const VideoRun video = make_video({4, false, false}, kSeed, 0);
  EXPECT_NEAR(pdim_levels(video).noise_db, 0.0, 0.3);
  EXPECT_NEAR(pdim_levels(video).snr_db, 8.54, 0.5);
  EXPECT_LT(block_levels(video).snr_db, pdim_levels(video).snr_db);
}

TEST(VideoRun, ThePrintedFloorLowersTheNoise) {
  const VideoRun ours = make_video({4, false, false}, kSeed, 0);
  const VideoRun printed = make_video({4, false, true}, kSeed, 0);
  EXPECT_LT(printed.frames[0].noise_level, ours.frames[0].noise_level);
}

TEST(VideoRun, AMethodIsFollowedOverEveryScan) {
  const VideoRun video = make_video({4, false, false}, kSeed, 0);
  tracking::GatedCentroidParams params;
  params.target_area = video.scenario.area;
  const auto tracker = tracking::make_gated_centroid(params);
  double cpu_ms = -1.0;
  const auto estimates = follow(video, *tracker, cpu_ms);
  ASSERT_EQ(estimates.size(), 20u);
  EXPECT_GE(cpu_ms, 0.0);
  EXPECT_LT((estimates.back().state.head<2>() - video.samples.back().new_centroid).norm(), 2.0);
}

}  // namespace
}  // namespace lookout::tools
