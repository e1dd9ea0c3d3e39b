#pragma once

#include <array>
#include <span>

#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

// The likelihood of a scan whose pose is uncertain: a target may have been in any beam about the one where
// the stated pose puts it, and its likelihood ratio is the mean over those beams, each weighted with the
// probability that the target was in it. All targets of a scan share the error; here each has its own, which
// loses what they tell of each other. This project's own; docs/scan_likelihood.md.

inline constexpr int kMostBlurReach = 8;  ///< Beams to either side; what lies beyond counts as the outermost.
inline constexpr std::size_t kBlurBlock = 64;  ///< Most targets that `find_blurred_ratios` takes at a time.

/// Writes into `ratio` the likelihood ratios, target there against none, that a scan with `blur_reach` > 0
/// gives targets at these ranges [m] and bearings from its axis [rad], at most `kBlurBlock` of them and as
/// many of each; 1 beyond the maximum range. Vectorised; single precision.
/// @param mask what other targets own of this scan; null: nothing.
void find_blurred_ratios(const ScanTable& scan, const BeamMask* mask, std::span<const float> range,
                         std::span<const float> bearing, const Tolerance& tolerance, std::span<float> ratio);

/// The logarithm of one, for a position in the earth frame [m], in double precision and the plainest form
/// [nats].
double blurred_log_ratio(const ScanTable& scan, const BeamMask* mask, const Eigen::Vector2d& p_earth,
                         const Tolerance& tolerance);

/// In which beams a target at one position was, now that the scan is known.
struct BeamShares {
  int count = 0;                                       ///< How many entries are filled.
  std::array<int, 2 * kMostBlurReach + 1> beam{};      ///< -1 or num_beams outside the sector.
  std::array<double, 2 * kMostBlurReach + 1> share{};  ///< Probabilities that sum to 1.
};
/// Those of a position in the earth frame [m]: the probability of each beam by the errors of the pose, times
/// the likelihood ratio of what it returned, normalised.
BeamShares beam_shares(const ScanTable& scan, const Eigen::Vector2d& p_earth, const Tolerance& tolerance);

}  // namespace lookout::csht
