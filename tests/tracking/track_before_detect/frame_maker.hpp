#pragma once

#include <cmath>

#include "core/random.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Cells of a frame: the first one's place and how many [pixels].
struct CellBlock {
  int column, row;             ///< Of the first.
  int width = 12, height = 8;  ///< The video paper's target.
};

/// The test frame of the iteration table: sqrt(.5 + U(0, 1)) + .3 |N(0, 1)| in every cell and a target of
/// 7 + N(0, 1) in the cells of `target`; the noise level is the median.
inline IntensityFrame noisy_frame(int columns, int rows, const CellBlock& target, core::Random& random) {
  IntensityFrame frame{columns, rows, {}};
  for (int i = 0; i < columns * rows; ++i)
    frame.values.push_back(std::sqrt(0.5 + random.uniform(0.0, 1.0)) + 0.3 * std::abs(random.gaussian()));
  for (int y = target.row; y < target.row + target.height; ++y)
    for (int x = target.column; x < target.column + target.width; ++x)
      frame.values[frame.index(x, y)] = std::max(0.0, 7.0 + random.gaussian());
  frame.noise_level = median_of(frame.values);
  return frame;
}

}  // namespace lookout::tracking
