#pragma once

#include <span>

namespace lookout::csht {

// Sonars report ranges in (0, max_range] alone. Near either end, noise takes the range of some returns out of
// it, and the beam is silent: a silence there says less against a target than elsewhere.
// docs/scan_likelihood.md.

/// Writes to `lost` the probability that noise takes a return of a target at each range [m] out of the gate,
/// within 1e-6. Vectorised; single precision.
/// @param inverse_sigma of the noise [1/m]. @param lost as many as ranges.
/// @return false, with nothing written, where no range is within four sigma of an end.
bool find_lost_shares(float max_range, float inverse_sigma, std::span<const float> range,
                      std::span<float> lost);

/// Probability that range alone takes an echo, at most.
inline constexpr float kMostRangeLoss = 0.95F;

/// Writes to `heard` the probability that range leaves an echo of a target at each range [m], and lets `lost`
/// grow by it. @param loss by the square of range [1/m^2], >= 0. @param lost as many as ranges, set.
void add_range_loss(float loss, std::span<const float> range, std::span<float> lost, std::span<float> heard);

/// One of them: the probability that range leaves an echo.
double heard_share(double loss, double range);

/// Probability that noise takes a return of a target at `range` [m] out of the gate, in double precision and
/// the plainest form.
double lost_share(double max_range, double inverse_sigma, double range);

}  // namespace lookout::csht
