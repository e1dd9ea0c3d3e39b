#include "tracking/track_before_detect/images/cell_measurement.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kEchoVariance = 2.885;       // of a cell's power over that of the echo in it: 2 / ln 2
constexpr double kCellVariance = 1.0 / 12.0;  // of an even spread over one cell
constexpr double kLeastInformation = 0.25;    // share of the information that a hidden assignment leaves
constexpr double kLongestStep = 1.5;          // [signatures] of one iteration
constexpr double kReach = 3.0;                // [signatures] of a target beyond which it gives nothing
constexpr double kUnrestMemory = 0.85;        // per frame
constexpr double kMostSurprise = 8.0;         // that one frame counts for
constexpr double kTurning = 0.2;  // probability of a straight course below which the filter follows the turn
constexpr int kSettledAge = 6;    // frames of a track, from which on it says how measured places scatter

bool odd(int n) {
  return n >= 1 && n % 2 == 1;
}

/// Covariance of the error after a measurement of variance `noise` that is taken in with any gain.
Eigen::Matrix4d error_after(const Eigen::Matrix4d& before, const Eigen::Matrix<double, 4, 2>& gain,
                            const Eigen::Matrix2d& jacobian, const Eigen::Array2d& noise) {
  Eigen::Matrix4d kept = Eigen::Matrix4d::Identity();
  kept.leftCols<2>() -= gain * jacobian;
  return kept * before * kept.transpose() + gain * noise.matrix().asDiagonal() * gain.transpose();
}

}  // namespace

void check(const CellMeasurementParams& p) {
  core::require(p.sigma.minCoeff() > 0.0, "sigma must be > 0", p.sigma.minCoeff());
  core::require(odd(p.gate_columns), "gate_columns must be odd", p.gate_columns);
  core::require(odd(p.gate_rows), "gate_rows must be odd", p.gate_rows);
  core::require(p.iterations >= 1, "iterations must be >= 1", p.iterations);
  core::require(p.threshold >= 0.0, "threshold must be >= 0", p.threshold);
  core::require(p.intensity_memory >= 0.0 && p.intensity_memory < 1.0, "intensity_memory must be in [0, 1)",
                p.intensity_memory);
  core::require(p.min_intensity > 0.0, "min_intensity must be > 0", p.min_intensity);
  core::require_not_negative("systematic", p.systematic);
  core::require(p.gate > 0.0, "gate must be > 0", p.gate);
  core::require(p.variance_factor > 0.0, "variance_factor must be > 0", p.variance_factor);
}

void CellMeasurement::update(const ScaleSpace& scales, const CellGeometry& geometry,
                             std::span<CellTrack> tracks, std::span<const Eigen::Vector2d> starts) {
  start(scales, geometry, tracks, starts);
  for (int i = 0; i < params_.iterations; ++i) {
    for (std::size_t k = 0; k < tracks.size(); ++k)
      if (clouds_[k].active) open_gate(scales.scales()[clouds_[k].scale], clouds_[k]);
    for (std::size_t k = 0; k < tracks.size(); ++k)
      if (clouds_[k].active) collect(scales, k);
    for (std::size_t k = 0; k < tracks.size(); ++k)
      if (clouds_[k].active) correct(scales.scales()[clouds_[k].scale], geometry, clouds_[k], tracks[k]);
  }
  for (std::size_t k = 0; k < tracks.size(); ++k) finish(clouds_[k], tracks[k]);
}

void CellMeasurement::start(const ScaleSpace& scales, const CellGeometry& geometry,
                            std::span<const CellTrack> tracks, std::span<const Eigen::Vector2d> starts) {
  if (clouds_.size() < tracks.size()) clouds_.resize(tracks.size());
  for (Cloud& cloud : clouds_) cloud.active = false;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    Cloud& cloud = clouds_[k];
    const CellView view = geometry.observe(tracks[k].state.head<2>());
    cloud.scale = static_cast<std::size_t>(tracks[k].scale);
    const ScaledFrame& scaled = scales.scales()[cloud.scale];
    cloud.predicted = tracks[k].state;
    cloud.covariance = tracks[k].covariance;
    cloud.error = tracks[k].error;
    cloud.view = scaled.to_scale(view);
    cloud.active = view.inside;
    cloud.found = false;
    cloud.mean = scaled.to_scale(starts[k]);
    cloud.intensity = std::max(params_.min_intensity, tracks[k].intensity);
  }
}

void CellMeasurement::open_gate(const ScaledFrame& scaled, Cloud& cloud) const {
  const int columns = scaled.frame.columns, rows = scaled.frame.rows;
  const int column = static_cast<int>(std::floor(cloud.mean.x()));
  const int row = static_cast<int>(std::floor(cloud.mean.y()));
  CellWindow& gate = cloud.gate;
  gate.first_column = std::clamp(column - params_.gate_columns / 2, 0, columns);
  gate.last_column = std::clamp(column + params_.gate_columns / 2 + 1, 0, columns);
  gate.first_row = std::clamp(row - params_.gate_rows / 2, 0, rows);
  gate.last_row = std::clamp(row + params_.gate_rows / 2 + 1, 0, rows);
  const Eigen::Array2d variance = params_.sigma.array().square();
  cloud.x.compute(cloud.mean.x(), variance.x(), gate.first_column, gate.columns());
  cloud.y.compute(cloud.mean.y(), variance.y(), gate.first_row, gate.rows());
}

/// Overwrites neighbours_ with the other clouds that reach the gate of cloud k.
void CellMeasurement::find_neighbours(const ScaleSpace& scales, std::size_t k) {
  neighbours_.clear();
  const Cloud& own = clouds_[k];
  const Eigen::Array2d half(0.5 * params_.gate_columns, 0.5 * params_.gate_rows);
  for (std::size_t j = 0; j < clouds_.size(); ++j) {
    if (j == k || !clouds_[j].active) continue;
    const Eigen::Array2d ratio = scales.scales()[clouds_[j].scale].cells_of(scales.scales()[own.scale]);
    const Eigen::Array2d apart = (clouds_[j].mean.array() * ratio - own.mean.array()).abs();
    if ((apart < half + kReach * params_.sigma.array() * ratio).all()) neighbours_.push_back(j);
  }
}

/// What another target gives to a cell of a scale. Where it is measured in another scale: by its density
/// there; the mean power of a pooled cell's noise, its unit, falls as the number of the cells pooled.
double CellMeasurement::intensity_of(const ScaleSpace& scales, const Cloud& cloud, const ScaledFrame& scaled,
                                     int column, int row) const {
  const ScaledFrame& own = scales.scales()[cloud.scale];
  if (own.scale == scaled.scale) {
    if (!cloud.gate.contains(column, row)) return 0.0;
    return cloud.intensity *
           cloud.x.probability()[static_cast<std::size_t>(column - cloud.gate.first_column)] *
           cloud.y.probability()[static_cast<std::size_t>(row - cloud.gate.first_row)];
  }
  const Eigen::Array2d ratio = own.cells_of(scaled);
  const Eigen::Array2d sigma = params_.sigma.array() * ratio;
  const Eigen::Array2d off = (Eigen::Array2d(column + 0.5, row + 0.5) - cloud.mean.array() * ratio) / sigma;
  const double density = std::exp(-0.5 * off.square().sum()) / (2.0 * std::numbers::pi * sigma.prod());
  return cloud.intensity * density;
}

/// Shares each cell of the gate among background and targets.
void CellMeasurement::collect(const ScaleSpace& scales, std::size_t k) {
  const ScaledFrame& scaled = scales.scales()[clouds_[k].scale];
  find_neighbours(scales, k);
  Cloud& own = clouds_[k];
  Sums& sums = own.sums = {};
  for (int row = own.gate.first_row; row < own.gate.last_row; ++row)
    for (int column = own.gate.first_column; column < own.gate.last_column; ++column) {
      const auto i = static_cast<std::size_t>(column - own.gate.first_column);
      const auto j = static_cast<std::size_t>(row - own.gate.first_row);
      const double px = own.x.probability()[i], py = own.y.probability()[j];
      double expected = scaled.displayed_mean + own.intensity * px * py;
      for (const std::size_t n : neighbours_)
        expected += intensity_of(scales, clouds_[n], scaled, column, row);
      const double share = own.intensity * px * py / expected;
      const Eigen::Array2d off(column + 0.5 - own.mean.x(), row + 0.5 - own.mean.y());
      const double variance = scaled.displayed_variance + kEchoVariance * own.intensity * px * py;
      sums.noise += share * share * variance * off.square();
      const double amplitude = scaled.frame.at(column, row);
      if (amplitude <= params_.threshold) continue;
      const double value = amplitude * amplitude;
      sums.intensity += value * share;
      sums.missing += value * share * ((1.0 - share) * off.square() + kCellVariance);
      const double weight = own.intensity * value / expected;
      sums.first.x() += weight * own.x.first()[i] * py;
      sums.first.y() += weight * px * own.y.first()[j];
    }
}

/// Kalman update of the prediction with the synthetic measurement, linearised at the prediction.
void CellMeasurement::correct(const ScaledFrame& scaled, const CellGeometry& geometry, Cloud& cloud,
                              CellTrack& track) const {
  const Sums& sums = cloud.sums;
  cloud.intensity = std::max(sums.intensity, 1e-3 * params_.min_intensity);
  cloud.found = sums.intensity >= params_.min_intensity;
  if (!cloud.found) return;
  const Eigen::Array2d variance = params_.sigma.array().square();
  const Eigen::Array2d kept = (1.0 - sums.missing / (sums.intensity * variance)).cwiseMax(kLeastInformation);
  const Eigen::Array2d longest = kLongestStep * params_.sigma.array();
  const Eigen::Array2d step =
      (sums.first.array() / (sums.intensity * kept)).cwiseMax(-longest).cwiseMin(longest);
  const Eigen::Vector2d measured = cloud.mean + step.matrix();
  cloud.stated = params_.variance_factor * scaled.correlation * sums.noise / (sums.intensity * kept).square();
  cloud.noise = scatter_.factor(cloud.scale) * cloud.stated;
  const Eigen::Matrix<double, 4, 2> PH = cloud.covariance.leftCols<2>() * cloud.view.jacobian.transpose();
  Eigen::Matrix2d S = cloud.view.jacobian * PH.topRows<2>();
  S.diagonal() += cloud.noise.matrix();
  const Eigen::Matrix2d S_inverse = S.inverse();
  cloud.innovation = measured - cloud.view.cell;
  const double distance = cloud.innovation.dot(S_inverse * cloud.innovation);
  cloud.surprise = 0.5 * distance;
  cloud.found = distance <= params_.gate;
  const Eigen::Matrix<double, 4, 2> gain = PH * S_inverse;
  track.state = cloud.predicted + gain * cloud.innovation;
  track.covariance = cloud.covariance - gain * PH.transpose();
  track.covariance = (0.5 * (track.covariance + track.covariance.transpose())).eval();
  track.error = error_after(cloud.error, gain, cloud.view.jacobian, cloud.noise);
  cloud.mean = scaled.to_scale(geometry.observe(track.state.head<2>())).cell;
}

/// What lies outside its gate is not the target: the prediction stands.
void CellMeasurement::finish(const Cloud& cloud, CellTrack& track) {
  track.measured = cloud.active && cloud.found;
  if (!cloud.active) return;
  track.intensity += (1.0 - params_.intensity_memory) * (cloud.intensity - track.intensity);
  track.unrest += (1.0 - kUnrestMemory) * (std::min(cloud.surprise, kMostSurprise) - track.unrest);
  if (cloud.found) {
    track.course.update({cloud.predicted.head<2>(), cloud.view.jacobian, cloud.innovation, cloud.noise});
    if (track.course.begun() && track.course.straight() < kTurning) track.state = track.course.merged().mean;
    return learn_scatter(cloud, track);
  }
  track.state = cloud.predicted;
  track.covariance = cloud.covariance;
  track.error = cloud.error;
}

/// From what is a target and keeps its course: what turns, or is none, is off for reasons of its own.
void CellMeasurement::learn_scatter(const Cloud& cloud, const CellTrack& track) {
  if (!track.confirmed || track.age < kSettledAge || track.unrest > CellTrack::kRestless) return;
  const Eigen::Matrix2d predicted =
      cloud.view.jacobian * cloud.error.topLeftCorner<2, 2>() * cloud.view.jacobian.transpose();
  scatter_.learn(cloud.scale, cloud.innovation, predicted.diagonal(), cloud.stated);
}

}  // namespace lookout::tracking
