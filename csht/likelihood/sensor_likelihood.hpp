#pragma once

#include <Eigen/Core>
#include <span>

#include "csht/likelihood/beam_mask.hpp"
#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// Hypothetical targets at a reference time, one array a component (earth frame, m and m/s), all of one size.
struct HypothesisSpan {
  std::span<const double> north;                     ///< [m].
  std::span<const double> east;                      ///< [m].
  std::span<const double> north_velocity;            ///< [m/s].
  std::span<const double> east_velocity;             ///< [m/s].
  std::size_t size() const { return north.size(); }  ///< How many hypotheses.
};

/// Where each hypothesis, moved by `seconds` along its velocity, is seen from a scan: range [m], and bearing
/// from the scan's axis [rad], of uneven beams as if they were even: in beams, times the mean step.
/// Vectorised; single precision.
void locate(const ScanTable& scan, const HypothesisSpan& hypotheses, double seconds, std::span<float> range,
            std::span<float> bearing);

/// By how much more than the sensor's own errors a hypothesis may miss a return. A search starts wide; the
/// last word is exact.
struct Tolerance {
  double sigma_scale = 1.0;  ///< Factor on the range (and a point sensor's bearing) sigma, >= 1.
  /// Half width of a softened beam edge [beams], in (0, 0.5]: within it the likelihood is a normalised
  /// mixture of both beams. At a hard edge a cloud of hypotheses would lose all members on the wrong side at
  /// once.
  double edge_softness = 0.1;
};

/// Adds to `log_ratio[i]` the log-likelihood ratio of one scan, target i there against no target there, with
/// the hypotheses moved by `seconds` (the scan's time less their reference time) along their velocity. Zero
/// outside the field of view. Vectorised over the hypotheses; allocates nothing.
/// @param mask what other targets own of this scan; null or empty: nothing.
void add_log_ratio(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                   double seconds, const Tolerance& tolerance, std::span<double> log_ratio);

/// The same as a factor on `product[i]`: without logarithms, for runs of scans short enough that the product
/// neither overflows nor vanishes.
void multiply_by_ratio(const ScanTable& scan, const BeamMask* mask, const HypothesisSpan& hypotheses,
                       double seconds, const Tolerance& tolerance, std::span<double> product);

/// ln(e^log_ratio + e^log_birth) for each hypothesis: targets that appear now join those that were there.
void add_births(double log_birth, std::span<double> log_ratio);

/// The same as `add_log_ratio` for one position, in double precision and the plainest form: the reference
/// that the fast one is tested and measured against.
double log_ratio(const ScanTable& scan, const BeamMask* mask, const Eigen::Vector2d& p_earth,
                 const Tolerance& tolerance = {});

}  // namespace lookout::csht
