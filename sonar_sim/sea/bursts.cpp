#include "sonar_sim/sea/bursts.hpp"

#include <algorithm>

namespace lookout::sonar_sim {
namespace {

void apply(const Burst& burst, core::SonarParams& params) {
  if (params.clutter_per_scan) *params.clutter_per_scan *= burst.factor;
  if (!params.false_alarm_probability) return;
  double& p_f = *params.false_alarm_probability;
  p_f = burst.false_alarm_probability.value_or(std::min(1.0, burst.factor * p_f));
}

}  // namespace

void apply_bursts(const std::vector<Burst>& bursts, double time, core::SonarParams& params) {
  for (const auto& burst : bursts)
    if (time >= burst.start && time < burst.start + burst.duration) apply(burst, params);
}

}  // namespace lookout::sonar_sim
