#pragma once

#include <cmath>

#include "sonar_sim/ping.hpp"

namespace lookout::sonar_sim {

inline constexpr int kPings = 20000;

/// A ping of the default sonar (90 beams of 1 degree, 150 m) at the origin, heading north.
inline Ping ping_at_origin() {
  Ping ping;
  ping.params.miss_probability = 0.1;
  ping.params.false_alarm_probability = 0.1;
  return ping;
}

/// The echo of a target in `beam` at `range` [m].
inline BeamReturn echo_in(const Ping& ping, int beam, double range) {
  return {beam, {ping.params.beam_centre(beam), range, 1.0}, Source::target};
}

/// Five binomial standard errors of a rate.
inline double rate_tolerance(double rate, double trials) {
  return 5.0 * std::sqrt(rate * (1.0 - rate) / trials);
}

/// Five standard errors of a mean, and of a variance of Gaussian values.
inline double mean_tolerance(double sigma, double trials) {
  return 5.0 * sigma / std::sqrt(trials);
}
inline double variance_tolerance(double sigma, double trials) {
  return 5.0 * sigma * sigma * std::sqrt(2.0 / trials);
}

}  // namespace lookout::sonar_sim
