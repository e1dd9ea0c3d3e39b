#include "tracking/track_before_detect/images/peak_tracker.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kNoMatch = 1e6;  // cost of a pair outside the gate

void check(const PeakTrackerParams& p) {
  core::require(p.threshold > 0.0, "threshold must be > 0", p.threshold);
  core::require(p.guard_cells >= 0, "guard_cells must be >= 0", p.guard_cells);
  core::require(p.reference_cells >= 1, "reference_cells must be >= 1", p.reference_cells);
  core::require(p.measurement_sigma.minCoeff() > 0.0, "measurement_sigma must be > 0",
                p.measurement_sigma.minCoeff());
  core::require(p.acceleration_density > 0.0, "acceleration_density must be > 0", p.acceleration_density);
  core::require(p.start_speed_sigma > 0.0, "start_speed_sigma must be > 0", p.start_speed_sigma);
  core::require(p.max_speed > 0.0, "max_speed must be > 0", p.max_speed);
  core::require(p.gate > 0.0, "gate must be > 0", p.gate);
  core::require(p.confirm_hits >= 1, "confirm_hits must be >= 1", p.confirm_hits);
  core::require(p.confirm_window >= p.confirm_hits, "confirm_window must be >= confirm_hits",
                p.confirm_window);
  core::require(p.max_misses >= 1, "max_misses must be >= 1", p.max_misses);
  core::require(p.max_tracks >= 1, "max_tracks must be >= 1", p.max_tracks);
}

/// Filter of one tap: the frame as it is.
MatchedFilterParams filter_of(const PeakTrackerParams& params) {
  MatchedFilterParams filter = params.filter;
  if (params.detector == PeakDetector::cell_cfar) filter.sigma = {1e-3, 1e-3};
  return filter;
}

}  // namespace

PeakTrackerParams matched_filter_baseline() {
  return {};
}

PeakTrackerParams cfar_baseline() {
  PeakTrackerParams params;
  params.detector = PeakDetector::cell_cfar;
  params.threshold = 2.75;
  return params;
}

void cell_averaging_ratio(const IntensityFrame& frame, int guard_cells, int reference_cells,
                          IntensityFrame& ratio) {
  ratio.columns = frame.columns;
  ratio.rows = frame.rows;
  ratio.values.assign(frame.values.size(), 0.0);
  for (int row = 0; row < frame.rows; ++row)
    for (int column = 0; column < frame.columns; ++column) {
      double sum = 0.0;
      int count = 0;
      for (int off = guard_cells + 1; off <= guard_cells + reference_cells; ++off)
        for (const int near : {column - off, column + off})
          if (near >= 0 && near < frame.columns) sum += frame.at(near, row), ++count;
      if (sum > 0.0) ratio.values[frame.index(column, row)] = frame.at(column, row) * count / sum;
    }
}

PeakTracker::PeakTracker(const PeakTrackerParams& params) : params_(params), filter_(filter_of(params)) {
  check(params);
}

const std::vector<CellTrack>& PeakTracker::update(const IntensityFrame& frame, const CellGeometry& geometry,
                                                  double time) {
  detect(frame);
  predict(time);
  associate(geometry, time);
  confirm_and_end();
  start_tracks(geometry, time);
  return tracks_;
}

void PeakTracker::reset() {
  tracks_.clear();
  lives_.clear();
}

void PeakTracker::detect(const IntensityFrame& frame) {
  if (params_.detector == PeakDetector::cell_cfar) {
    cell_averaging_ratio(frame, params_.guard_cells, params_.reference_cells, ratio_);
    filter_.apply(ratio_);
  } else {
    filter_.apply(frame);
  }
  filter_.find_peaks(params_.threshold, peaks_);
  places_.clear();
  for (const FramePeak& peak : peaks_)
    places_.push_back(params_.between_cells ? filter_.place_of(peak)
                                            : Eigen::Vector2d(peak.column + 0.5, peak.row + 0.5));
}

void PeakTracker::predict(double time) {
  const double step = time - last_time_;
  last_time_ = time;
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const Eigen::Matrix4d Q = params_.acceleration_density * core::white_acceleration_noise(step, 1.0);
  for (CellTrack& track : tracks_) {
    track.state = (F * track.state).eval();
    track.covariance = (F * track.covariance * F.transpose() + Q).eval();
    ++track.age;
  }
}

Eigen::Matrix2d PeakTracker::innovation_covariance(const CellTrack& track, const CellView& view) const {
  Eigen::Matrix2d S = view.jacobian * track.covariance.topLeftCorner<2, 2>() * view.jacobian.transpose();
  S.diagonal().array() += params_.measurement_sigma.array().square();
  return S;
}

void PeakTracker::associate(const CellGeometry& geometry, double time) {
  used_.assign(peaks_.size(), 0);
  if (tracks_.empty()) return;
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(tracks_.size()), static_cast<Eigen::Index>(peaks_.size()));
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const CellView view = geometry.observe(tracks_[k].state.head<2>());
    const Eigen::Matrix2d S_inverse = innovation_covariance(tracks_[k], view).inverse();
    for (std::size_t j = 0; j < peaks_.size(); ++j) {
      const Eigen::Vector2d residual = places_[j] - view.cell;
      const double distance = residual.dot(S_inverse * residual);
      cost(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) =
          distance < params_.gate ? distance : kNoMatch;
    }
  }
  const std::vector<int> pairs = peaks_.empty() ? std::vector<int>(tracks_.size(), -1) : solver_.solve(cost);
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    const CellView view = geometry.observe(tracks_[k].state.head<2>());
    tracks_[k].inside = view.inside;
    const int j = pairs[k];
    const bool hit = j >= 0 && cost(static_cast<Eigen::Index>(k), j) < kNoMatch;
    lives_[k].misses = hit ? 0 : lives_[k].misses + 1;
    if (!hit) continue;
    ++lives_[k].hits;
    used_[static_cast<std::size_t>(j)] = 1;
    tracks_[k].last_detection_time = time;
    correct(tracks_[k], view, places_[static_cast<std::size_t>(j)]);
  }
}

void PeakTracker::correct(CellTrack& track, const CellView& view, const Eigen::Vector2d& measured) const {
  const Eigen::Matrix<double, 4, 2> PH = track.covariance.leftCols<2>() * view.jacobian.transpose();
  const Eigen::Matrix<double, 4, 2> gain = PH * innovation_covariance(track, view).inverse();
  track.state += gain * (measured - view.cell);
  track.covariance -= gain * PH.transpose();
  track.covariance = (0.5 * (track.covariance + track.covariance.transpose())).eval();
}

void PeakTracker::confirm_and_end() {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    CellTrack& track = tracks_[k];
    if (lives_[k].hits >= params_.confirm_hits) track.confirmed = true;
    track.existence = track.confirmed ? 1.0 : 0.5;
    track.error = track.covariance;
    const bool too_slow = !track.confirmed && track.age + 1 >= params_.confirm_window;
    const bool silent = lives_[k].misses >= params_.max_misses;
    if (too_slow || silent || !track.inside || track.state.tail<2>().norm() > params_.max_speed) continue;
    if (kept != k) std::tie(tracks_[kept], lives_[kept]) = std::pair{tracks_[k], lives_[k]};
    ++kept;
  }
  tracks_.resize(kept);
  lives_.resize(kept);
}

void PeakTracker::start_tracks(const CellGeometry& geometry, double time) {
  for (std::size_t j = 0; j < peaks_.size(); ++j) {
    if (used_[j] != 0 || static_cast<int>(tracks_.size()) >= params_.max_tracks) continue;
    CellTrack track;
    track.id = next_id_++;
    track.state.head<2>() = geometry.position_of(places_[j]);
    const Eigen::Matrix2d to_position = geometry.observe(track.state.head<2>()).jacobian.inverse();
    const Eigen::Vector2d cells = params_.measurement_sigma.array().square();
    track.covariance.topLeftCorner<2, 2>() = to_position * cells.asDiagonal() * to_position.transpose();
    track.covariance(2, 2) = track.covariance(3, 3) = params_.start_speed_sigma * params_.start_speed_sigma;
    track.error = track.covariance;
    track.existence = 0.5;
    track.first_time = track.last_detection_time = time;
    tracks_.push_back(track);
    lives_.push_back({1, 0});
  }
}

}  // namespace lookout::tracking
