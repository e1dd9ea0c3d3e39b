#include "tracking/detection/image_geometry.hpp"

namespace lookout::tracking {

void copy_geometry(const core::SonarImage& image, ImageGeometry& geometry) {
  geometry.bearings.assign(image.bearings.begin(), image.bearings.end());
  geometry.first_range = image.first_range;
  geometry.range_step = image.range_step;
  geometry.num_bins = image.num_bins;
}

}  // namespace lookout::tracking
