#include "tracking/track_before_detect/images/cell_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kReachSigmas = 2.5;  // of a target's filtered signature around its centre
constexpr double kDetectionRank =
    0.05;  // a block among the best twentieth counts as a detection of the track's own

bool odd(int n) {
  return n >= 1 && n % 2 == 1;
}

void check(const CellMeasurementParams& p) {
  core::require(p.sigma.minCoeff() > 0.0, "sigma must be > 0", p.sigma.minCoeff());
  core::require(odd(p.gate_columns), "gate_columns must be odd", p.gate_columns);
  core::require(odd(p.gate_rows), "gate_rows must be odd", p.gate_rows);
  core::require(p.iterations >= 1, "iterations must be >= 1", p.iterations);
  core::require(p.threshold >= 0.0, "threshold must be >= 0", p.threshold);
  core::require(p.intensity_memory >= 0.0 && p.intensity_memory < 1.0, "intensity_memory must be in [0, 1)",
                p.intensity_memory);
  core::require(p.min_intensity > 0.0, "min_intensity must be > 0", p.min_intensity);
  core::require(p.variance_factor > 0.0, "variance_factor must be > 0", p.variance_factor);
}

void check(const CellMotionParams& p) {
  core::require(p.acceleration_density > 0.0, "acceleration_density must be > 0", p.acceleration_density);
  core::require(p.start_speed_sigma > 0.0, "start_speed_sigma must be > 0", p.start_speed_sigma);
  core::require(p.max_speed > 0.0, "max_speed must be > 0", p.max_speed);
}

void check(const CellExistenceParams& p) {
  const auto probability = [](double v) { return v > 0.0 && v < 1.0; };
  core::require(probability(p.birth_quantile), "birth_quantile must be in (0, 1)", p.birth_quantile);
  core::require(probability(p.birth_existence), "birth_existence must be in (0, 1)", p.birth_existence);
  core::require(probability(p.rank_exponent), "rank_exponent must be in (0, 1)", p.rank_exponent);
  core::require(p.survival > 0.0 && p.survival <= 1.0, "survival must be in (0, 1]", p.survival);
  core::require(probability(p.confirm_existence), "confirm_existence must be in (0, 1)", p.confirm_existence);
  core::require(p.min_age >= 0, "min_age must be >= 0", p.min_age);
  core::require(p.delete_tentative >= 0.0 && p.delete_tentative < p.birth_existence,
                "delete_tentative must be >= 0 and below birth_existence", p.delete_tentative);
  core::require(p.delete_confirmed >= 0.0 && p.delete_confirmed < p.confirm_existence,
                "delete_confirmed must be >= 0 and below confirm_existence", p.delete_confirmed);
  core::require(p.merge_distance >= 0.0, "merge_distance must be >= 0", p.merge_distance);
  core::require(p.birth_distance >= 0.0, "birth_distance must be >= 0", p.birth_distance);
  core::require_not_negative("sidelobe_ratio", p.sidelobe_ratio);
  core::require(p.leave_out_existence >= 0.0 && p.leave_out_existence <= 1.0,
                "leave_out_existence must be in [0, 1]", p.leave_out_existence);
  core::require(p.coast >= 0.0, "coast must be >= 0", p.coast);
  core::require(p.max_tracks >= 1, "max_tracks must be >= 1", p.max_tracks);
}

}  // namespace

void check(const CellTrackerParams& params) {
  check(params.measurement);
  check(params.motion);
  check(params.existence);
}

CellTracker::CellTracker(const CellTrackerParams& params)
    : params_(params), filter_(params.filter), measurement_(params.measurement) {
  check(params);
  tracks_.reserve(static_cast<std::size_t>(params.existence.max_tracks));
}

const std::vector<CellTrack>& CellTracker::update(const IntensityFrame& frame, const CellGeometry& geometry,
                                                  double time) {
  predict(time);
  filter_.apply(frame);
  measurement_.update(frame, geometry, tracks_);
  leave_out_confirmed(geometry);
  judge(geometry, time);
  end_tracks(time);
  merge(geometry);
  start_tracks(geometry, time);
  return tracks_;
}

void CellTracker::reset() {
  tracks_.clear();
}

void CellTracker::predict(double time) {
  const double step = time - last_time_;
  last_time_ = time;
  if (tracks_.empty()) return;
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const Eigen::Matrix4d Q = params_.motion.acceleration_density * core::white_acceleration_noise(step, 1.0);
  for (CellTrack& track : tracks_) {
    track.state = (F * track.state).eval();
    track.covariance = (F * track.covariance * F.transpose() + Q).eval();
    track.existence *= params_.existence.survival;
    ++track.age;
  }
}

/// Leaves the blocks that confirmed targets reach out of the background among which blocks are ranked.
void CellTracker::leave_out_confirmed(const CellGeometry& geometry) {
  windows_.clear();
  const Eigen::Vector2d reach =
      kReachSigmas * params_.filter.sigma +
      0.5 * Eigen::Vector2d(params_.filter.block_columns, params_.filter.block_rows);
  for (const CellTrack& track : tracks_) {
    if (!track.confirmed && track.existence < params_.existence.leave_out_existence) continue;
    const Eigen::Vector2d cell = geometry.observe(track.state.head<2>()).cell;
    const Eigen::Array2i low = (cell - reach).array().floor().cast<int>();
    const Eigen::Array2i high = (cell + reach).array().ceil().cast<int>();
    windows_.push_back({low.x(), high.x(), low.y(), high.y()});
  }
  if (!windows_.empty()) filter_.leave_out(windows_);
}

/// Bayes' rule on the rank of the track's block: density a p^(a - 1) with a target, uniform without.
void CellTracker::judge(const CellGeometry& geometry, double time) {
  const CellExistenceParams& p = params_.existence;
  for (CellTrack& track : tracks_) {
    const CellView view = geometry.observe(track.state.head<2>());
    if (track.inside && !view.inside) track.outside_since = time;
    track.inside = view.inside;
    if (!view.inside) continue;
    const double rank = rank_of(track, view);
    const double ratio = p.rank_exponent * std::pow(rank, p.rank_exponent - 1.0);
    track.existence = ratio * track.existence / (ratio * track.existence + 1.0 - track.existence);
    if (rank < kDetectionRank) track.last_detection_time = time;
    if (track.existence > p.confirm_existence && track.age >= p.min_age) track.confirmed = true;
  }
}

/// A block may be bright because of a neighbouring target: where the frame held nothing of the track's own
/// signature, its block counts as no detection and ranks last.
double CellTracker::rank_of(const CellTrack& track, const CellView& view) const {
  if (!track.measured) return 1.0;
  return filter_.rank(
      filter_.block_maximum(static_cast<int>(view.cell.x()), static_cast<int>(view.cell.y())));
}

void CellTracker::end_tracks(double time) {
  const CellExistenceParams& p = params_.existence;
  std::erase_if(tracks_, [&](const CellTrack& track) {
    const bool unlikely = track.existence < (track.confirmed ? p.delete_confirmed : p.delete_tentative);
    const bool gone = !track.inside && (!track.confirmed || time - track.outside_since >= p.coast);
    return unlikely || gone || track.state.tail<2>().norm() > params_.motion.max_speed;
  });
}

/// Of two tracks in one place the confirmed one stays, then the older.
void CellTracker::merge(const CellGeometry& geometry) {
  merged_.assign(tracks_.size(), 0);
  const auto stays = [](const CellTrack& a, const CellTrack& b) {
    return a.confirmed != b.confirmed ? a.confirmed : a.age >= b.age;
  };
  for (std::size_t i = 0; i < tracks_.size(); ++i)
    for (std::size_t j = i + 1; j < tracks_.size(); ++j) {
      if (merged_[i] || merged_[j]) continue;
      const Eigen::Vector2d apart = geometry.observe(tracks_[i].state.head<2>()).cell -
                                    geometry.observe(tracks_[j].state.head<2>()).cell;
      if (apart.norm() >= params_.existence.merge_distance) continue;
      merged_[stays(tracks_[i], tracks_[j]) ? j : i] = 1;
    }
  std::size_t index = 0;
  std::erase_if(tracks_, [&](const CellTrack&) { return merged_[index++] != 0; });
}

/// Whether the peak belongs to a track: it is near it, or it may be its sidelobe, weak and at its range.
bool CellTracker::belongs_to_a_track(const CellGeometry& geometry, const FramePeak& peak) const {
  const CellExistenceParams& p = params_.existence;
  const Eigen::Vector2d centre(peak.column + 0.5, peak.row + 0.5);
  return std::any_of(tracks_.begin(), tracks_.end(), [&](const CellTrack& track) {
    const CellView view = geometry.observe(track.state.head<2>());
    if ((view.cell - centre).norm() < p.birth_distance) return true;
    if (!view.inside || std::abs(view.cell.x() - centre.x()) > p.birth_distance) return false;
    const double strength =
        filter_.block_maximum(static_cast<int>(view.cell.x()), static_cast<int>(view.cell.y()));
    return peak.value < p.sidelobe_ratio * strength;
  });
}

void CellTracker::start_tracks(const CellGeometry& geometry, double time) {
  filter_.find_peaks(filter_.quantile(params_.existence.birth_quantile), peaks_);
  for (const FramePeak& peak : peaks_) {
    if (static_cast<int>(tracks_.size()) >= params_.existence.max_tracks) return;
    if (belongs_to_a_track(geometry, peak)) continue;
    CellTrack track;
    track.id = next_id_++;
    track.state.head<2>() = geometry.position_of({peak.column + 0.5, peak.row + 0.5});
    const Eigen::Matrix2d to_position = geometry.observe(track.state.head<2>()).jacobian.inverse();
    const Eigen::Vector2d cells = params_.measurement.sigma.array().square();
    track.covariance.topLeftCorner<2, 2>() = to_position * cells.asDiagonal() * to_position.transpose();
    const double speed = params_.motion.start_speed_sigma;
    track.covariance(2, 2) = track.covariance(3, 3) = speed * speed;
    track.existence = params_.existence.birth_existence;
    track.first_time = track.last_detection_time = time;
    tracks_.push_back(track);
  }
}

}  // namespace lookout::tracking
