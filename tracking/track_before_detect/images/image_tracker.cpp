#include "tracking/track_before_detect/images/image_tracker.hpp"

#include <cmath>
#include <stdexcept>

#include "core/beam_bearings.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kWidthOfDeviation = 2.3548;    // full width at half amplitude of a normal density
constexpr double kNextScale = 1.42;             // half of the way to the next scale, as a ratio
constexpr double kSpeedMargin = 4.0 / 3.0;      // of an estimate over the fastest target
constexpr double kStartSpeedShare = 1.0 / 3.0;  // of the fastest target: deviation of an unknown velocity
constexpr double kMovingSpeedShare = 0.5;       // and of the velocity of what moves, against what stands
constexpr double kSlowestShare = 0.1;           // and the slowest target, where it is not told

std::unique_ptr<CellTargetTracker> make_targets(std::string_view method, const InstrumentParams& instrument) {
  if (method == "h_pmht") return std::make_unique<CellTracker>(sonar_tracker_params(instrument));
  if (method == "mf_nn") return std::make_unique<PeakTracker>(matched_filter_baseline());
  if (method == "cfar_nn") return std::make_unique<PeakTracker>(cfar_baseline());
  throw std::invalid_argument("image tracker must be h_pmht, mf_nn or cfar_nn, got " + std::string(method));
}

core::TrackStatus status_of(const CellTrack& track) {
  if (!track.confirmed) return core::TrackStatus::tentative;
  return track.inside ? core::TrackStatus::confirmed : core::TrackStatus::coasting;
}

GaussianMode as_filtered(const CellTrack& track) {
  return {1.0, track.state, track.error};
}

bool finite(const core::Pose2& pose) {
  return std::isfinite(pose.north) && std::isfinite(pose.east) && std::isfinite(pose.heading);
}

}  // namespace

std::string image_fault(const core::PosedImage& posed) {
  const core::SonarImage& image = posed.image;
  const auto cells = static_cast<long long>(image.num_beams()) * image.num_bins;
  if (image.num_beams() < 1 || image.num_bins < 1 || static_cast<long long>(image.intensity.size()) != cells)
    return "size";
  if (!(core::is_beam_table(image.bearings) && std::isfinite(image.first_range) && image.range_step > 0.0 &&
        std::isfinite(image.range_step)))
    return "geometry";
  if (!finite(posed.T_earth_sonar)) return "pose";
  for (const double value : image.intensity)
    if (!(value >= 0.0 && std::isfinite(value))) return "intensity";
  return "";
}

CellTrackerParams sonar_tracker_params(const InstrumentParams& instrument) {
  core::require_not_negative("pulse_length", instrument.pulse_length);
  core::require_not_negative("beam_width", instrument.beam_width);
  core::require_positive("max_speed", instrument.max_speed);
  core::require_positive("birth_rate", instrument.birth_rate);
  CellTrackerParams params;
  params.scales.signature =
      Eigen::Vector2d(instrument.pulse_length, instrument.beam_width) / kWidthOfDeviation;
  params.scales.largest = params.scales.largest.cwiseMax(kNextScale * params.scales.signature);
  params.motion.max_speed = kSpeedMargin * instrument.max_speed;
  params.motion.start_speed_sigma = kStartSpeedShare * instrument.max_speed;
  params.standing.speed_sigma = kMovingSpeedShare * instrument.max_speed;
  params.standing.mark_time = instrument.mark_time;
  params.existence.birth_rate = instrument.birth_rate;
  return params;
}

ImageBackgroundParams sonar_background_params(const InstrumentParams& instrument) {
  core::require_not_negative("slowest", instrument.slowest);
  ImageBackgroundParams params;
  params.slowest = instrument.slowest > 0.0 ? instrument.slowest : kSlowestShare * instrument.max_speed;
  params.beam_width = instrument.beam_width;
  return params;
}

ImageTracker::ImageTracker(std::string_view method, const InstrumentParams& instrument)
    : background_(sonar_background_params(instrument)), targets_(make_targets(method, instrument)) {}

ImageTracker::ImageTracker(std::unique_ptr<CellTargetTracker> targets,
                           const ImageBackgroundParams& background)
    : background_(background), targets_(std::move(targets)) {}

std::span<const core::Track> ImageTracker::update(const core::PosedImage& posed) {
  if (!accept(posed)) return tracks_;
  const SonarCellGeometry geometry(posed);
  const IntensityFrame& frame = background_.normalise(posed);
  publish(targets_->update(frame, geometry, core::seconds(posed.image.utime)));
  if (const CellClaims* claims = targets_->claims()) background_.learn(claims->targets, claims->standing);
  return tracks_;
}

bool ImageTracker::accept(const core::PosedImage& posed) {
  if (!image_fault(posed).empty()) {
    ++counts_.damaged;
    return false;
  }
  if (started_ && posed.image.utime <= last_utime_) {
    ++counts_.out_of_order;
    return false;
  }
  started_ = true;
  last_utime_ = posed.image.utime;
  ++counts_.accepted;
  return true;
}

void ImageTracker::publish(const std::vector<CellTrack>& tracks) {
  tracks_.clear();
  for (const CellTrack& track : tracks) {
    core::Track out;
    out.id = track.id;
    out.status = status_of(track);
    const GaussianMode course = track.course.begun() ? track.course.merged() : as_filtered(track);
    out.state = course.mean;
    out.covariance = course.covariance;
    out.covariance.topLeftCorner<2, 2>() += track.systematic;
    out.existence = track.existence;
    out.first_utime = core::microseconds(track.first_time);
    out.last_detection_utime = core::microseconds(track.last_detection_time);
    tracks_.push_back(out);
  }
}

void ImageTracker::reset() {
  targets_->reset();
  tracks_.clear();
  started_ = false;
}

}  // namespace lookout::tracking
