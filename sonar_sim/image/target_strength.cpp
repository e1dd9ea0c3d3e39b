#include "sonar_sim/image/target_strength.hpp"

#include <cmath>

namespace lookout::sonar_sim {

double TargetStrength::amplitude(std::int32_t id, double time) {
  if (plan_.swerling == 0) return 1.0;
  const bool at_every_ping = plan_.swerling % 2 == 0;
  if (at_every_ping) return draw();
  Dwell& dwell = dwells_[id];
  const double number = std::floor(time / plan_.dwell);
  if (number != dwell.number) dwell = {number, draw()};
  return dwell.amplitude;
}

/// The root of a power: exponential, or chi-square of four degrees of freedom over its mean, which is the
/// mean of two exponential ones.
double TargetStrength::draw() {
  const auto exponential = [this] { return -std::log(1.0 - random_.uniform(0.0, 1.0)); };
  const double first = exponential();
  if (plan_.swerling <= 2) return std::sqrt(first);
  return std::sqrt(0.5 * (first + exponential()));
}

}  // namespace lookout::sonar_sim
