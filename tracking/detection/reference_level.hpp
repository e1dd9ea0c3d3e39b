#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/detection/detection_params.hpp"
#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

inline constexpr std::string_view kCellAveraging = "cell_averaging";        ///< [Finn1968]
inline constexpr std::string_view kOrderedStatistic = "ordered_statistic";  ///< [Rohling1983]
inline constexpr std::string_view kSmallestOf = "smallest_of";              ///< [Trunk1978]

/// The mean power of the background at a cell, from the cells around it: what makes a detector one of a
/// constant false-alarm rate (CFAR).
class ReferenceLevel {
 public:
  virtual ~ReferenceLevel() = default;
  /// Takes the plane of a ping, which must stay as it is until the next call.
  virtual void prepare(const ImagePlane& plane, const DetectionWindow& window) = 0;
  /// Level at a cell of the plane, > 0 where the reference cells hold anything.
  virtual float at(int beam, int bin) const = 0;
};

/// Names of the registry: "cell_averaging", "ordered_statistic" and "smallest_of".
std::vector<std::string> reference_level_names();

/// @throws std::invalid_argument for a name that is none of reference_level_names().
std::unique_ptr<ReferenceLevel> make_reference_level(const ReferenceParams& params);

}  // namespace lookout::tracking
