#pragma once

#include <cstdint>

namespace lookout::csht {

/// One coordinate of a detection at its time: a point of the line position = intercept + velocity * time,
/// which votes in the Hough space of its axis. [Yan2018] calls it a position-time sampling point (section
/// III, Fig. 8).
struct LineSample {
  std::int64_t scan = 0;  ///< Number of its scan; those of one scan stand together.
  double time = 0.0;      ///< [s].
  double position = 0.0;  ///< [m].
  double sigma = 1.0;     ///< Standard deviation of `position` [m].
  double weight = 1.0;    ///< Of its vote, in [0, 1]: less where false returns are dense.
};

/// A line at a reference time of the caller's choice.
struct Line {
  double velocity = 0.0;   ///< [m/s].
  double intercept = 0.0;  ///< Position at the reference time [m].
};

}  // namespace lookout::csht
