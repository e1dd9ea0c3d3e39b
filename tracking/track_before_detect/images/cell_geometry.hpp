#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/beam_bearings.hpp"
#include "core/sonar_image.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Where a position lies in the image: x along columns, y along rows, cell centres at .5.
struct CellView {
  Eigen::Vector2d cell{0, 0};                              ///< Column, row.
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();  ///< d cell / d position.
  bool inside = false;                                     ///< Whether it lies in the image.
};

/// How positions map to cells of the image at hand.
class CellGeometry {
 public:
  virtual ~CellGeometry() = default;
  /// Where a position lies in the image.
  virtual CellView observe(const Eigen::Vector2d& position) const = 0;
  /// The position of a place in the image.
  virtual Eigen::Vector2d position_of(const Eigen::Vector2d& cell) const = 0;
  /// How much a cell covers along columns and rows: of a sonar image metres of range and radians of bearing
  /// (on average, where beams are uneven), of a picture pixels.
  virtual Eigen::Vector2d cell_size() const = 0;
};

/// Columns are range bins, rows are beams, even or not; positions are north, east [m]; the sonar's own pose
/// is part of it.
class SonarCellGeometry : public CellGeometry {
 public:
  /// Takes pose, beams and bins of the image; keeps no reference.
  explicit SonarCellGeometry(const core::PosedImage& posed);
  CellView observe(const Eigen::Vector2d& p_earth) const override;
  Eigen::Vector2d position_of(const Eigen::Vector2d& cell) const override;
  Eigen::Vector2d cell_size() const override { return {range_step_, core::mean_step(bearings_)}; }

 private:
  core::Pose2 T_earth_sonar_;
  std::vector<double> bearings_;
  double first_range_, range_step_;
  int num_bins_;
};

/// Positions are pixels.
class PixelGeometry : public CellGeometry {
 public:
  /// @param columns, rows of the frame, > 0.
  PixelGeometry(int columns, int rows) : columns_(columns), rows_(rows) {}
  CellView observe(const Eigen::Vector2d& position) const override;
  Eigen::Vector2d position_of(const Eigen::Vector2d& cell) const override { return cell; }
  Eigen::Vector2d cell_size() const override { return {1.0, 1.0}; }

 private:
  int columns_, rows_;
};

/// The cells within `reach` of a place along columns and rows, whether they lie in the image or not.
CellWindow window_about(const Eigen::Vector2d& cell, const Eigen::Vector2d& reach);

/// Whether two images have the same beams and bins.
bool same_cells(const core::SonarImage& a, const core::SonarImage& b);

/// Pose, beams and bins of an image alone.
core::PosedImage without_intensities(const core::PosedImage& posed);

}  // namespace lookout::tracking
