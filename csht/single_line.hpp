#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csht/hough_space.hpp"
#include "csht/line_sample.hpp"

namespace lookout::csht {

/// Which cells around the peak make the line.
struct SingleLineParams {
  double peak_share = 0.7;  ///< Cells with more than this share of the peak's votes, in [0, 1).
  double radius = 4.0;      ///< Cells within this distance of the peak [grid steps], >= 0.
};

/// The one line that most line samples lie on: the weighted mean of the cells at the peak of their votes.
/// [Yan2018] section III.B, "extraction of a single line".
class SingleLine {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  SingleLine(const SingleLineParams& params, HoughSpace space);

  /// @return the line through its intercept at `time` [s], around `centre` [m]; nothing without line samples.
  std::optional<Line> extract(std::span<const LineSample> samples, double time, double centre);

 private:
  SingleLineParams params_;
  HoughSpace space_;
  std::vector<VoteCell> cells_;
};

}  // namespace lookout::csht
