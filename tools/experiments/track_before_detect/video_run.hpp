#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sonar_sim/video_stand_in.hpp"
#include "tracking/track_before_detect/frames/frame_tracker.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tools {

/// How a video of the stand-in is made and prepared.
struct VideoKind {
  int scenario = 1;            ///< Of [Pakfiliz2018] Table 2, 1 .. 8.
  bool hard = false;           ///< With movers that cross the path and more jitter.
  bool printed_floor = false;  ///< PDIM with Eq. (3) as printed.
};

/// One video, prepared for tracking.
struct VideoRun {
  sonar_sim::VideoScenario scenario;             ///< Its row of Table 2.
  std::vector<sonar_sim::VideoSample> samples;   ///< Grey frames and truth.
  std::vector<tracking::IntensityFrame> frames;  ///< Scan k from samples k and k + 1.
  Eigen::Vector4d start{0, 0, 0, 0};             ///< What every method is told, px and px/frame.
  Eigen::Matrix4d start_covariance = Eigen::Matrix4d::Zero();  ///< Of `start`.
};

/// The video of a kind, seed and run.
VideoRun make_video(const VideoKind& kind, std::uint64_t seed, int run);

/// The target at every scan, as a method that is given the start follows it.
/// @param cpu_ms receives the processor time of this thread.
std::vector<tracking::FrameTrack> follow(const VideoRun& video, tracking::FrameTracker& tracker,
                                         double& cpu_ms);

/// Levels of a video as [Pakfiliz2018] Table 2 states them, 10 log10.
struct VideoLevels {
  double noise_db = 0.0;  ///< Mean where the target is not.
  double snr_db = 0.0;    ///< Mean where it newly is, over that.
};
/// Of the PDIM intensities, in the cells that the target newly covers.
VideoLevels pdim_levels(const VideoRun& video);
/// Of the 5 x 5 block means that the amplitude information of IMMPDA-AI is: in the blocks half of whose cells
/// are newly covered, and where a scan has none in its highest block near the target.
VideoLevels block_levels(const VideoRun& video);

}  // namespace lookout::tools
