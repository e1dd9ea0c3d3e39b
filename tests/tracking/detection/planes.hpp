#pragma once

#include <algorithm>

#include "tracking/detection/image_plane.hpp"

namespace lookout::testing {

/// A plane of one value.
inline tracking::ImagePlane flat(int beams, int bins, float value = 1.0F) {
  tracking::ImagePlane plane;
  plane.resize(beams, bins);
  std::fill(plane.values.begin(), plane.values.end(), value);
  return plane;
}

/// Sets one cell.
inline void set(tracking::ImagePlane& plane, int beam, int bin, float value) {
  plane.row(beam)[static_cast<std::size_t>(bin)] = value;
}

}  // namespace lookout::testing
