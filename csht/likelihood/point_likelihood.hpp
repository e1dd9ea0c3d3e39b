#pragma once

#include <cstddef>
#include <span>

#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

// The likelihood of a scan of a sensor without beams: a target makes one return with Gaussian errors of range
// and bearing, or none, among clutter uniform over both. Where the sensor has a resolution, the return of a
// target near another's is one with it, by the probability m = share x 2^-(distance / resolution)^2 of the
// best claimed return: its likelihood ratio L becomes (1 - m) L + m, so that having no return of its own says
// nothing. This project's own; docs/scan_likelihood.md. Without a resolution it is
// the usual one in Poisson clutter, [BarShalom2011].

inline constexpr std::size_t kPointBlock = 64;  ///< Most targets that `find_point_ratios` takes at a time.

/// Writes into `ratio` the likelihood ratios, target there against none, that a scan gives targets at these
/// ranges [m] and bearings from its axis [rad], at most `kPointBlock` of them and as many of each; 1 outside
/// the field of view. Vectorised; single precision.
/// @param mask what other targets own of this scan; null: nothing.
void find_point_ratios(const ScanTable& scan, const BeamMask* mask, std::span<const float> range,
                       std::span<const float> bearing, const Tolerance& tolerance, std::span<float> ratio);

/// One of them, in double precision and the plainest form; the range within the maximum.
double plain_point_ratio(const ScanTable& scan, const BeamMask* mask, double range, double bearing,
                         const Tolerance& tolerance);

}  // namespace lookout::csht
