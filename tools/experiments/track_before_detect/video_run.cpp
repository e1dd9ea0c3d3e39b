#include "tools/experiments/track_before_detect/video_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "tools/cli/thread_time.hpp"
#include "tracking/track_before_detect/frames/immpda_ai.hpp"
#include "tracking/track_before_detect/frames/pdim.hpp"

namespace lookout::tools {
namespace {

constexpr double kStartPositionSigma = 2.0;  // [px], of the start that every method is given
constexpr double kStartVelocitySigma = 0.2;  // [px/scan]; docs/track_before_detect.md on the unit
constexpr double kHalf = 0.5;                // of the contrast, and of a block's cells
constexpr int kBlock = 5;                    // [px], side of a block of [Pakfiliz2018] Eq. (24)
constexpr double kNearTarget = 3.0;          // [px] about its box

/// Sums of intensities where the target is not and where it newly is.
struct LevelSums {
  double noise = 0.0, num_noise = 0.0, signal = 0.0, num_signal = 0.0;

  void add_noise(double value) { noise += value, num_noise += 1.0; }
  void add_signal(double value) { signal += value, num_signal += 1.0; }
  VideoLevels levels() const {
    const auto decibels = [](double ratio) { return 10.0 * std::log10(ratio); };
    const double mean_noise = noise / std::max(1.0, num_noise);
    return {decibels(mean_noise), decibels(signal / std::max(1.0, num_signal) / mean_noise)};
  }
};

bool near(const sonar_sim::VideoSample& sample, const Eigen::Vector2d& p) {
  return (p.array() >= sample.box.low.array() - kNearTarget).all() &&
         (p.array() <= sample.box.high.array() + kNearTarget).all();
}

/// What the target newly covers at scan k: it darkened by more than half of its contrast, in its box.
bool newly_covered(const VideoRun& video, std::size_t k, int column, int row) {
  const auto& frame = video.frames[k];
  const Eigen::Vector2d centre(column + kHalf, row + kHalf);
  if (column >= frame.columns || row >= frame.rows || !video.samples[k + 1].box.contains(centre))
    return false;
  const std::size_t cell = frame.index(column, row);
  return video.samples[k].grey[cell] - video.samples[k + 1].grey[cell] > kHalf * video.scenario.contrast();
}

/// Share of a block's cells that the target newly covers.
double covered_share(const VideoRun& video, std::size_t k, const Eigen::Vector2d& centre) {
  const int left = static_cast<int>(centre.x() - kHalf * kBlock),
            top = static_cast<int>(centre.y() - kHalf * kBlock);
  int covered = 0;
  for (int i = 0; i < kBlock * kBlock; ++i)
    covered += newly_covered(video, k, left + i % kBlock, top + i / kBlock) ? 1 : 0;
  return static_cast<double>(covered) / (kBlock * kBlock);
}

void add_blocks(const VideoRun& video, std::size_t k, LevelSums& sums) {
  std::vector<tracking::AmplitudePoint> blocks;
  tracking::extract_points(video.frames[k], kBlock, 0.0, blocks);
  double highest = 0.0;
  const double before = sums.num_signal;
  for (const tracking::AmplitudePoint& block : blocks) {
    const bool now = near(video.samples[k + 1], block.position);
    if (!now && !near(video.samples[k], block.position)) sums.add_noise(block.amplitude);
    if (now) highest = std::max(highest, block.amplitude);
    if (now && covered_share(video, k, block.position) >= kHalf) sums.add_signal(block.amplitude);
  }
  if (sums.num_signal == before) sums.add_signal(highest);
}

}  // namespace

VideoRun make_video(const VideoKind& kind, std::uint64_t seed, int run) {
  VideoRun video;
  video.scenario = sonar_sim::video_scenarios().at(static_cast<std::size_t>(kind.scenario - 1));
  const auto stream = static_cast<std::uint64_t>(run) * 8 + static_cast<std::uint64_t>(kind.scenario - 1);
  core::Random random(seed, core::RandomStream::images, stream);
  const sonar_sim::VideoStandIn stand_in(
      video.scenario, kind.hard ? sonar_sim::hard_video() : sonar_sim::plain_video(), random);
  for (int k = 0; k < stand_in.num_samples(); ++k) video.samples.push_back(stand_in.render(k, random));
  const tracking::PdimParams pdim{tracking::Polarity::dark, video.scenario.noise_level(), kind.printed_floor};
  const int size = video.scenario.size;
  for (std::size_t k = 1; k < video.samples.size(); ++k)
    video.frames.push_back(
        tracking::pdim_frame(video.samples[k - 1].grey, video.samples[k].grey, size, size, pdim, random));
  const double velocity_sigma = kStartVelocitySigma / video.scenario.frame_step;  // [px/frame], as the state
  const Eigen::Array4d sigma(kStartPositionSigma, kStartPositionSigma, velocity_sigma, velocity_sigma);
  video.start << video.samples[0].centroid, stand_in.velocity(0);
  for (int i = 0; i < 4; ++i) video.start[i] += random.gaussian(sigma[i]);
  video.start_covariance = sigma.square().matrix().asDiagonal();
  return video;
}

std::vector<tracking::FrameTrack> follow(const VideoRun& video, tracking::FrameTracker& tracker,
                                         double& cpu_ms) {
  std::vector<tracking::FrameTrack> estimates;
  const double begin = thread_time_ms();
  tracker.add(1, video.start, video.start_covariance);
  const auto batch = static_cast<std::size_t>(tracker.batch_length());
  for (std::size_t k = 0; k < video.frames.size(); k += batch) {
    const std::size_t size = std::min(batch, video.frames.size() - k);
    const std::vector<double> steps(size, video.scenario.frame_step);
    for (const auto& tracks : tracker.process({video.frames.data() + k, size}, steps))
      estimates.push_back(tracks.front());
  }
  cpu_ms = thread_time_ms() - begin;
  return estimates;
}

VideoLevels pdim_levels(const VideoRun& video) {
  LevelSums sums;
  for (std::size_t k = 0; k < video.frames.size(); ++k)
    for (int row = 0; row < video.frames[k].rows; ++row)
      for (int column = 0; column < video.frames[k].columns; ++column) {
        const Eigen::Vector2d centre(column + kHalf, row + kHalf);
        const double value = video.frames[k].at(column, row);
        if (newly_covered(video, k, column, row)) sums.add_signal(value);
        if (!near(video.samples[k + 1], centre) && !near(video.samples[k], centre)) sums.add_noise(value);
      }
  return sums.levels();
}

VideoLevels block_levels(const VideoRun& video) {
  LevelSums sums;
  for (std::size_t k = 0; k < video.frames.size(); ++k) add_blocks(video, k, sums);
  return sums.levels();
}

}  // namespace lookout::tools
