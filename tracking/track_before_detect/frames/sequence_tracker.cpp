#include "tracking/track_before_detect/frames/sequence_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kSmallestSigma = 0.75;  // [px] of a target's signature; a point fills about one pixel
constexpr double kGateSigmas = 3.5;      // half the gate's side
constexpr double kBlockSigmas = 1.0;     // half the block's side
// A frame has fewer blocks than a sonar image, so that the rank of one says less: the threshold is lower.
constexpr double kConfirmExistence = 0.99;
constexpr double kBirthExpectation = 5.0;
constexpr double kBirthsPerFrame = 8.0;
constexpr int kMinAge = 2;
constexpr double kSpotVariance = 1.0;           // [px^2] of a spot's position
constexpr double kSpotSpeedVariance = 0.5;      // [px^2 / frame^2]
constexpr double kSpotReach = 3.0;              // [px] in which a method's estimate is that of its spot
constexpr double kAcceleration = 0.1;           // [px^2 / frame^3]
constexpr double kStartSpeedShare = 1.0 / 3.0;  // of the fastest speed, one standard deviation

int odd_width(double half) {
  return 2 * static_cast<int>(std::ceil(half)) + 1;
}

}  // namespace

CellTrackerParams pixel_tracker_params(const TbdParams& params) {
  const double sigma = std::max(kSmallestSigma, std::sqrt(params.target_area / (4.0 * std::numbers::pi)));
  CellTrackerParams cells;
  cells.scales.filter.sigma = {sigma, sigma};
  cells.measurement.sigma = cells.scales.filter.sigma / std::numbers::sqrt2;
  cells.measurement.gate_columns = cells.measurement.gate_rows = odd_width(kGateSigmas * sigma);
  cells.scales.filter.block_columns = cells.scales.filter.block_rows = odd_width(kBlockSigmas * sigma);
  cells.measurement.threshold = displayed_threshold(1.0, params.dct_db);
  cells.motion.max_speed = params.max_speed;
  cells.motion.start_speed_sigma = kStartSpeedShare * params.max_speed;
  cells.motion.agile_density = kAcceleration;
  cells.standing.judged = false;
  cells.scales.same_on_both_axes = true;
  cells.existence.confirm_existence = kConfirmExistence;
  cells.existence.birth_expectation = kBirthExpectation;
  cells.existence.births_per_frame = cells.existence.birth_rate = kBirthsPerFrame;
  cells.existence.min_age = kMinAge;
  cells.existence.merge_distance = sigma;
  cells.existence.birth_distance = kGateSigmas * sigma;
  cells.existence.sidelobe_ratio = 0.0;  // a picture has no beam pattern
  cells.existence.coast = 0.0;
  return cells;
}

namespace {

SpotParams spot_params(const TbdParams& params) {
  SpotParams spots;
  spots.polarity = params.polarity;
  return spots;
}

/// A spot as the track that a method may start from.
CellTrack track_of(const Spot& spot) {
  CellTrack track;
  track.id = spot.id;
  track.state << spot.position, spot.velocity;
  track.covariance =
      Eigen::Vector4d(kSpotVariance, kSpotVariance, kSpotSpeedVariance, kSpotSpeedVariance).asDiagonal();
  track.existence = 1.0 - std::exp(-spot.evidence);
  track.confirmed = spot.confirmed;
  return track;
}

}  // namespace

SequenceTracker::SequenceTracker(std::string_view method, const TbdParams& params)
    : params_(params),
      method_(make_frame_tracker(method, params)),
      judge_(pixel_tracker_params(params)),
      spots_(spot_params(params)) {
  if (!params.start) return;
  const double position = params.start_position_sigma * params.start_position_sigma;
  const double velocity = params.start_velocity_sigma * params.start_velocity_sigma;
  method_->add(1, *params.start, Eigen::Vector4d(position, position, velocity, velocity).asDiagonal());
}

const std::vector<std::vector<FrameTrack>>& SequenceTracker::process(
    std::span<const IntensityFrame> frames, std::span<const double> steps,
    std::span<const std::vector<double>> greys) {
  const bool spots = !params_.start && !greys.empty();
  if (spots) judge_spots(frames, steps, greys);
  if (!params_.start && !spots) judge(frames, steps);
  tracks_ = method_->process(frames, steps);
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    std::erase_if(tracks_[t], [](const FrameTrack& track) { return track.lost; });
    if (params_.start) continue;
    for (FrameTrack& track : tracks_[t]) track.existence = existence(t, track.id);
    std::erase_if(tracks_[t], [](const FrameTrack& track) { return track.existence <= 0.0; });
  }
  if (spots) hold_to_spots();
  if (!params_.start) follow_confirmed();
  return tracks_;
}

void SequenceTracker::judge_spots(std::span<const IntensityFrame> frames, std::span<const double> steps,
                                  std::span<const std::vector<double>> greys) {
  judged_.resize(frames.size());
  for (std::size_t t = 0; t < frames.size(); ++t) {
    judged_[t].clear();
    for (const Spot& spot : spots_.update(greys[t], frames[t].columns, frames[t].rows, steps[t]))
      judged_[t].push_back(track_of(spot));
  }
}

/// Reports each confirmed spot, where the method has it or, if the method has none near, where it is; the
/// method starts anew from a spot that it has departed from.
void SequenceTracker::hold_to_spots() {
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const std::vector<FrameTrack> estimated = std::move(tracks_[t]);
    tracks_[t].clear();
    for (const CellTrack& spot : judged_[t]) {
      const auto own = std::find_if(estimated.begin(), estimated.end(),
                                    [&](const FrameTrack& track) { return track.id == spot.id; });
      const bool near =
          own != estimated.end() && (own->state.head<2>() - spot.state.head<2>()).norm() < kSpotReach;
      if (!near && t + 1 == tracks_.size() && std::erase(followed_, spot.id) > 0) method_->remove(spot.id);
      if (!spot.confirmed) continue;
      tracks_[t].push_back(near ? *own : FrameTrack{spot.id, spot.state, spot.covariance, 0.0, 1.0, false});
      tracks_[t].back().existence = spot.existence;
    }
  }
}

void SequenceTracker::judge(std::span<const IntensityFrame> frames, std::span<const double> steps) {
  judged_.resize(frames.size());
  for (std::size_t t = 0; t < frames.size(); ++t) {
    scaled_ = frames[t];
    for (double& value : scaled_.values) value /= frames[t].noise_level;
    time_ += steps[t];
    judged_[t] = judge_.update(scaled_, PixelGeometry(scaled_.columns, scaled_.rows), time_);
  }
}

/// The method starts where the judge has confirmed a target and stops where it has ended one.
void SequenceTracker::follow_confirmed() {
  const std::vector<CellTrack>& now = judged_.back();
  std::erase_if(followed_, [&](std::int64_t id) {
    const bool ended = std::none_of(now.begin(), now.end(), [id](const CellTrack& t) { return t.id == id; });
    if (ended) method_->remove(id);
    return ended;
  });
  for (const CellTrack& track : now) {
    if (!track.confirmed || std::count(followed_.begin(), followed_.end(), track.id) > 0) continue;
    method_->add(track.id, track.state, track.covariance);
    followed_.push_back(track.id);
  }
}

double SequenceTracker::existence(std::size_t frame, std::int64_t id) const {
  for (const CellTrack& track : judged_[frame])
    if (track.id == id) return track.existence;
  return 0.0;
}

}  // namespace lookout::tracking
