#pragma once

#include <span>

namespace lookout::csht {

/// Log odds of a target after the scans of its life, the Bernoulli filter's recursion ([Ristic2013]).
/// @param before the first of these scans [nats]. @param gains evidence of each scan by age, the newest first
/// [nats]. @param survival by age: the probability, in (0, 1], of not vanishing between the scan before and
/// this one; at least as many as `gains`, that of the oldest is not used.
/// @return `before` where there is no scan.
double lived_odds(double before, std::span<const double> gains, std::span<const double> survival);

}  // namespace lookout::csht
