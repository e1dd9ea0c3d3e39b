#pragma once

#include <cmath>

#include "core/random.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// The test frame of the iteration table: sqrt(.5 + U(0, 1)) + .3 |N(0, 1)| in every cell and a target of
/// 7 + N(0, 1) in `width` x `height` cells from (column, row) on; the noise level is the median.
inline IntensityFrame noisy_frame(int columns, int rows, int column, int row, int width, int height,
                                  core::Random& random) {
  IntensityFrame frame{columns, rows, {}};
  for (int i = 0; i < columns * rows; ++i)
    frame.values.push_back(std::sqrt(0.5 + random.uniform(0.0, 1.0)) + 0.3 * std::abs(random.gaussian()));
  for (int y = row; y < row + height; ++y)
    for (int x = column; x < column + width; ++x)
      frame.values[frame.index(x, y)] = std::max(0.0, 7.0 + random.gaussian());
  frame.noise_level = median_of(frame.values);
  return frame;
}

}  // namespace lookout::tracking
