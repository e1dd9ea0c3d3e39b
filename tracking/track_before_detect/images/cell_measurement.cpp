#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tracking/track_before_detect/images/cell_tracker.hpp"

namespace lookout::tracking {

void CellMeasurement::update(const IntensityFrame& frame, const CellGeometry& geometry,
                             std::vector<CellTrack>& tracks) {
  background_ = mean_displayed(frame);
  start(frame, geometry, tracks);
  for (int i = 0; i < params_.iterations; ++i) {
    for (Cloud& cloud : clouds_)
      if (cloud.active) open_gate(frame, cloud);
    for (std::size_t k = 0; k < clouds_.size(); ++k)
      if (clouds_[k].active) collect(frame, k);
    for (std::size_t k = 0; k < clouds_.size(); ++k)
      if (clouds_[k].active) correct(geometry, clouds_[k], tracks[k]);
  }
  for (std::size_t k = 0; k < tracks.size(); ++k)
    tracks[k].measured = clouds_[k].active && clouds_[k].intensity >= params_.min_intensity;
  for (std::size_t k = 0; k < clouds_.size(); ++k)
    if (clouds_[k].active)
      tracks[k].intensity += (1.0 - params_.intensity_memory) * (clouds_[k].intensity - tracks[k].intensity);
}

/// Displayed intensity per cell of the frame: lambda_0, the few targets being a small part of it.
double CellMeasurement::mean_displayed(const IntensityFrame& frame) const {
  double sum = 0.0;
  for (const double value : frame.values) sum += value > params_.threshold ? value : 0.0;
  return std::max(1e-6, sum / static_cast<double>(frame.values.size()));
}

void CellMeasurement::start(const IntensityFrame& frame, const CellGeometry& geometry,
                            const std::vector<CellTrack>& tracks) {
  if (clouds_.size() < tracks.size()) clouds_.resize(tracks.size());
  for (Cloud& cloud : clouds_) cloud.active = false;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    Cloud& cloud = clouds_[k];
    cloud.predicted = tracks[k].state;
    cloud.covariance = tracks[k].covariance;
    cloud.view = geometry.observe(tracks[k].state.head<2>());
    cloud.active = cloud.view.inside;
    cloud.mean = cloud.view.cell;
    cloud.intensity = std::max(params_.min_intensity, tracks[k].intensity);
  }
  cells_.reserve(frame.values.size() / 8);
}

void CellMeasurement::open_gate(const IntensityFrame& frame, Cloud& cloud) const {
  const int column = static_cast<int>(std::floor(cloud.mean.x()));
  const int row = static_cast<int>(std::floor(cloud.mean.y()));
  CellWindow& gate = cloud.gate;
  gate.first_column = std::clamp(column - params_.gate_columns / 2, 0, frame.columns);
  gate.last_column = std::clamp(column + params_.gate_columns / 2 + 1, 0, frame.columns);
  gate.first_row = std::clamp(row - params_.gate_rows / 2, 0, frame.rows);
  gate.last_row = std::clamp(row + params_.gate_rows / 2 + 1, 0, frame.rows);
  const Eigen::Array2d variance = params_.sigma.array().square();
  cloud.x.compute(cloud.mean.x(), variance.x(), gate.first_column, gate.columns());
  cloud.y.compute(cloud.mean.y(), variance.y(), gate.first_row, gate.rows());
}

/// Shares each displayed cell of the gate among background and targets.
void CellMeasurement::collect(const IntensityFrame& frame, std::size_t k) {
  Cloud& own = clouds_[k];
  own.next_intensity = 0.0;
  own.first.setZero();
  collect_displayed(frame, params_.threshold, own.gate, 1, cells_);
  for (const DisplayedCell& cell : cells_) {
    double expected = background_;
    for (const Cloud& cloud : clouds_) {
      if (!cloud.active || !cloud.gate.contains(cell.column, cell.row)) continue;
      expected += cloud.intensity *
                  cloud.x.probability()[static_cast<std::size_t>(cell.column - cloud.gate.first_column)] *
                  cloud.y.probability()[static_cast<std::size_t>(cell.row - cloud.gate.first_row)];
    }
    const auto column = static_cast<std::size_t>(cell.column - own.gate.first_column);
    const auto row = static_cast<std::size_t>(cell.row - own.gate.first_row);
    const double weight = own.intensity * cell.intensity / expected;
    own.next_intensity += weight * own.x.probability()[column] * own.y.probability()[row];
    own.first.x() += weight * own.x.first()[column] * own.y.probability()[row];
    own.first.y() += weight * own.x.probability()[column] * own.y.first()[row];
  }
}

/// Kalman update of the prediction with the synthetic measurement, linearised at the prediction.
void CellMeasurement::correct(const CellGeometry& geometry, Cloud& cloud, CellTrack& track) const {
  cloud.intensity = std::max(cloud.next_intensity, 1e-3 * params_.min_intensity);
  if (cloud.next_intensity < params_.min_intensity) return;
  const Eigen::Vector2d measured = cloud.mean + cloud.first / cloud.next_intensity;
  const Eigen::Matrix<double, 4, 2> PH = cloud.covariance.leftCols<2>() * cloud.view.jacobian.transpose();
  Eigen::Matrix2d S = cloud.view.jacobian * PH.topRows<2>();
  S.diagonal().array() += params_.variance_factor / cloud.next_intensity * params_.sigma.array().square();
  const Eigen::Matrix<double, 4, 2> gain = PH * S.inverse();
  track.state = cloud.predicted + gain * (measured - cloud.view.cell);
  track.covariance = cloud.covariance - gain * PH.transpose();
  track.covariance = (0.5 * (track.covariance + track.covariance.transpose())).eval();
  cloud.mean = geometry.observe(track.state.head<2>()).cell;
}

}  // namespace lookout::tracking
