#pragma once

#include <span>
#include <vector>

#include "csht/line_sample.hpp"
#include "csht/single_line.hpp"

namespace lookout::csht {

/// Which lines of the two axes are one target.
struct SpatialCorrelationParams {
  double gate = 2.5;    ///< Largest residual of a line sample to its class's line, in the range sigma, > 0.
  int max_lines = 2;    ///< Lines of the second axis per class, > 0.
  int min_samples = 3;  ///< A second-axis line needs this many gated line samples, > 0.
};

/// The line samples near a class's line on the first axis, and the lines that the same detections make on the
/// second. [Yan2018] Eq. (41), with the residual taken at the line sample's own time and gated: false alarms
/// without a gate bias the line on the second axis.
class SpatialCorrelation {
 public:
  /// @param range_sigma [m]. @throws std::invalid_argument on a parameter out of range.
  SpatialCorrelation(const SpatialCorrelationParams& params, double range_sigma, SingleLine single_line);

  /// @param first the class's line at `time` on the first axis.
  /// @param along, across line samples of the first and the second axis, of the same detections in one order.
  /// @param centre the second axis's intercepts lie around it [m].
  /// @return at most `max_lines` lines of the second axis at `time`, the stronger first; valid until the next
  /// call.
  std::span<const Line> second_lines(const Line& first, std::span<const LineSample> along,
                                     std::span<const LineSample> across, double time, double centre);

 private:
  double gate_of(const LineSample& sample) const;
  void leave_samples_of(const Line& line, double time);

  SpatialCorrelationParams params_;
  double range_sigma_;
  SingleLine single_line_;
  std::vector<LineSample> gated_;
  std::vector<Line> lines_;
};

}  // namespace lookout::csht
