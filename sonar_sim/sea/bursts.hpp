#pragma once

#include <optional>
#include <vector>

#include "core/sonar_params.hpp"

namespace lookout::sonar_sim {

/// A time in which the background alarms more (or less) often: another sonar's ping, a wake, rain.
struct Burst {
  double start = 0.0;                             ///< Holds for start <= t < start + duration [s].
  double duration = 0.0;                          ///< [s], > 0.
  std::optional<double> false_alarm_probability;  ///< Either P_F in the burst, in [0, 1],
  double factor = 1.0;  ///< or what P_F (at most 1 comes of it) or clutter_per_scan is multiplied by, >= 0.
};

/// P_F and clutter_per_scan of `params` as they are at `time` [s]. Bursts that overlap act in their order.
void apply_bursts(const std::vector<Burst>& bursts, double time, core::SonarParams& params);

}  // namespace lookout::sonar_sim
