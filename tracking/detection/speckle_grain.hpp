#pragma once

#include <vector>

#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// How large the grains of the speckle are. Speckle is white sound seen through pulse and beam, so that its
/// grain is the extent of a point's echo: for a Gaussian pulse the power of the speckle is correlated to one
/// half over the half-power length of an echo divided by sqrt(2). Independent cells have the extent 1.
class SpeckleGrain {
 public:
  /// Adds a ping's normalised image; those before count less. Looks at every 8th beam: 8 products a cell.
  void add(const ImagePlane& plane);
  /// Extent of an echo by all pings so far; 1 by 1 before any.
  EchoExtent extent() const;
  void forget();  ///< The next ping is the first.

 private:
  void begin(const ImagePlane& plane);
  float mean_excess(const ImagePlane& plane) const;

  std::vector<double> over_beams_, along_range_;  ///< Sums of products by lag [cells].
};

}  // namespace lookout::tracking
