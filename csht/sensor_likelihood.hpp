#pragma once

#include <Eigen/Core>
#include <span>

#include "csht/beam_mask.hpp"
#include "csht/scan_table.hpp"

namespace lookout::csht {

/// Hypothetical targets at a reference time, one array a component (earth frame, m and m/s), all of one size.
struct HypothesisSpan {
  std::span<const double> north;
  std::span<const double> east;
  std::span<const double> north_velocity;
  std::span<const double> east_velocity;
  std::size_t size() const { return north.size(); }
};

/// Adds to `log_ratio[i]` the log-likelihood ratio of one scan, target i there against no target there, with
/// the hypotheses moved by `seconds` (the scan's time less their reference time) along their velocity. Zero
/// outside the field of view. Vectorised over the hypotheses; allocates nothing.
/// @param mask what other targets own of this scan; null or empty: nothing.
void add_log_ratio(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                   double seconds, std::span<double> log_ratio);

/// The same for one position, in double precision and the plainest form: the reference that the fast one is
/// tested and measured against.
double log_ratio(const ScanTable& scan, const BeamMask* mask, const Eigen::Vector2d& p_earth);

}  // namespace lookout::csht
