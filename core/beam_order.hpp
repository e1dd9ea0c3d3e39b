#pragma once

namespace lookout::core {

/// Describes the same fan of beams from port to starboard, so that `bearing_step` is positive: a sonar that
/// is mounted upside down, or whose driver counts from starboard, gives a negative one. Returns carry their
/// own bearings and stay as they are.
/// @param fan with `first_bearing` and `bearing_step` [rad] and `num_beams`.
template <class Fan>
void count_from_port(Fan& fan) {
  if (!(fan.bearing_step < 0.0)) return;
  fan.first_bearing += (fan.num_beams - 1) * fan.bearing_step;
  fan.bearing_step = -fan.bearing_step;
}

}  // namespace lookout::core
