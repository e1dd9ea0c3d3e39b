#pragma once

#include <span>

#include "tracking/track_before_detect/frames/pdim.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// How much two frames agree in which pixels are brighter than their median: quadrant correlation in [-1, 1].
/// Near 0 for noise, near 1 for a standing scene; a few moving pixels do not matter. Pixels at the median
/// count for nothing; 0 where few are off it.
double quadrant_correlation(std::span<const double> a, std::span<const double> b);

/// Robust standard deviation: 1.4826 median |v - median|; the mean absolute deviation where that is 0, and 1
/// where all values are equal.
double robust_sigma(std::span<const double> values);

/// A frame that shows its targets directly (no standing scene): the excess over the median in units of the
/// robust standard deviation, dark where it is negative. Noise level 1.
/// @throws std::invalid_argument where the size disagrees or a value is not finite.
IntensityFrame standardised_frame(std::span<const double> grey, int columns, int rows, Polarity polarity);

/// PDIM of two frames in grey levels of at least the noise of their difference, so that a noisy or finely
/// quantised sequence keeps the noise floor that Eq. (3) supposes.
IntensityFrame scaled_pdim_frame(std::span<const double> earlier, std::span<const double> later, int columns,
                                 int rows, Polarity polarity, core::Random& random);

}  // namespace lookout::tracking
