#pragma once

#include <vector>

#include "core/beam_bearings.hpp"
#include "core/sonar_image.hpp"

namespace lookout::tracking {

/// What an image was taken through.
struct ImageGeometry {
  std::vector<double> bearings;  ///< Centre of each beam [rad], increasing.
  double first_range = 0.0;      ///< Centre of bin 0 [m].
  double range_step = 0.0;       ///< Bin spacing [m], > 0 once known.
  int num_bins = 0;              ///< Of a beam.

  bool operator==(const ImageGeometry&) const = default;
  int num_beams() const { return static_cast<int>(bearings.size()); }  ///< Of the fan.
  double spacing() const { return core::mean_step(bearings); }         ///< Mean, of the beams [rad].
  /// [rad]; between two beams by its share.
  double bearing_at(double beam) const { return core::bearing_at(bearings, beam); }
  double range_at(double bin) const { return first_range + bin * range_step; }  ///< [m]
};

/// Copies an image's geometry without allocating where there is room.
void copy_geometry(const core::SonarImage& image, ImageGeometry& geometry);

}  // namespace lookout::tracking
