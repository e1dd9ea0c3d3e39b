#include "tracking/track_before_detect/images/cell_geometry.hpp"

#include <cmath>

#include "core/beam_bearings.hpp"

namespace lookout::tracking {
namespace {

bool inside(const Eigen::Vector2d& cell, int columns, int rows) {
  return cell.x() >= 0.0 && cell.x() < columns && cell.y() >= 0.0 && cell.y() < rows;
}

}  // namespace

SonarCellGeometry::SonarCellGeometry(const core::PosedImage& posed)
    : T_earth_sonar_(posed.T_earth_sonar),
      bearings_(posed.image.bearings),
      first_range_(posed.image.first_range),
      range_step_(posed.image.range_step),
      num_bins_(posed.image.num_bins) {}

CellView SonarCellGeometry::observe(const Eigen::Vector2d& p_earth) const {
  const Eigen::Vector2d p_sonar = core::inverse_transform(T_earth_sonar_, p_earth);
  const double range = p_sonar.norm();
  const double bearing = std::atan2(p_sonar.y(), p_sonar.x());
  const double place = core::place_of(bearings_, bearing);
  CellView view;
  view.cell = {(range - first_range_) / range_step_ + 0.5, place + 0.5};
  view.inside = range > 0.0 && inside(view.cell, num_bins_, static_cast<int>(bearings_.size()));
  if (range <= 0.0) return view;
  const double azimuth = bearing + T_earth_sonar_.heading;
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double beam_width = range * core::step_at(bearings_, place);
  view.jacobian << c / range_step_, s / range_step_, -s / beam_width, c / beam_width;
  return view;
}

Eigen::Vector2d SonarCellGeometry::position_of(const Eigen::Vector2d& cell) const {
  const double range = first_range_ + (cell.x() - 0.5) * range_step_;
  const double bearing = core::bearing_at(bearings_, cell.y() - 0.5);
  return core::transform(T_earth_sonar_, core::from_polar(range, bearing));
}

CellWindow window_about(const Eigen::Vector2d& cell, const Eigen::Vector2d& reach) {
  const Eigen::Array2i low = (cell - reach).array().floor().cast<int>();
  const Eigen::Array2i high = (cell + reach).array().ceil().cast<int>();
  return {low.x(), high.x(), low.y(), high.y()};
}

bool same_cells(const core::SonarImage& a, const core::SonarImage& b) {
  return a.bearings == b.bearings && a.num_bins == b.num_bins && a.first_range == b.first_range &&
         a.range_step == b.range_step;
}

core::PosedImage without_intensities(const core::PosedImage& posed) {
  core::PosedImage bare;
  bare.T_earth_sonar = posed.T_earth_sonar;
  bare.image.num_bins = posed.image.num_bins;
  bare.image.bearings = posed.image.bearings;
  bare.image.first_range = posed.image.first_range;
  bare.image.range_step = posed.image.range_step;
  return bare;
}

CellView PixelGeometry::observe(const Eigen::Vector2d& position) const {
  return {position, Eigen::Matrix2d::Identity(), inside(position, columns_, rows_)};
}

}  // namespace lookout::tracking
