#include "sonar_sim/echo_noise.hpp"

#include <algorithm>
#include <optional>

namespace lookout::sonar_sim {
namespace {

using core::Random;
using core::SonarReturn;

bool in_range(const core::SonarParams& params, double range) {
  return range > 0.0 && range <= params.max_range;
}

/// The echo of the target that owns a beam, or nothing: missed, or its noisy range falls outside the sonar's.
std::optional<SonarReturn> draw_echo(const SonarPlan& sonar, const BeamTarget& target, Random& random) {
  if (random.bernoulli(*sonar.params.miss_probability)) return std::nullopt;
  const double range = target.range + random.gaussian(sonar.echo_range_sigma);
  if (!in_range(sonar.params, range)) return std::nullopt;
  return SonarReturn{sonar.quantise_bearing ? sonar.params.beam_centre(target.beam) : target.bearing, range,
                     1.0};
}

SonarReturn draw_false_alarm(const SonarPlan& sonar, int beam, Random& random) {
  // max_range minus a draw of [0, max_range) lies in (0, max_range].
  const double range = sonar.params.max_range - random.uniform(0.0, sonar.params.max_range);
  return {sonar.params.beam_centre(beam), range, 1.0};
}

std::vector<int> empty_beams(const core::SonarParams& params, const std::vector<BeamTarget>& owners) {
  std::vector<int> beams;
  auto owner = owners.begin();
  for (int beam = 0; beam < params.num_beams; ++beam) {
    if (owner != owners.end() && owner->beam == beam) {
      ++owner;
    } else {
      beams.push_back(beam);
    }
  }
  return beams;
}

/// The mean number of false alarms under light clutter: P_F / (1 - P_F) for each expected detection.
double light_mean(const core::SonarParams& params, int num_visible) {
  const double p_f = *params.false_alarm_probability;
  return p_f / (1.0 - p_f) * num_visible * (1.0 - *params.miss_probability);
}

void add_false_alarms(const SonarPlan& sonar, std::vector<int> beams, int num_visible, Random& random,
                      std::vector<SonarReturn>& returns) {
  if (sonar.clutter == ClutterReading::literal) {
    for (const int beam : beams) {
      if (random.bernoulli(*sonar.params.false_alarm_probability))
        returns.push_back(draw_false_alarm(sonar, beam, random));
    }
    return;
  }
  for (int left = random.poisson(light_mean(sonar.params, num_visible)); left > 0 && !beams.empty(); --left) {
    const auto pick = beams.begin() + random.index(static_cast<int>(beams.size()));
    returns.push_back(draw_false_alarm(sonar, *pick, random));
    beams.erase(pick);
  }
}

}  // namespace

std::vector<SonarReturn> draw_beam_returns(const SonarPlan& sonar, const std::vector<BeamTarget>& owners,
                                           int num_visible, Random& random) {
  std::vector<SonarReturn> returns;
  for (const auto& owner : owners) {
    if (const auto echo = draw_echo(sonar, owner, random)) returns.push_back(*echo);
  }
  add_false_alarms(sonar, empty_beams(sonar.params, owners), num_visible, random, returns);
  std::sort(returns.begin(), returns.end(),
            [](const auto& a, const auto& b) { return a.bearing < b.bearing; });
  return returns;
}

std::vector<SonarReturn> draw_point_returns(const SonarPlan& sonar, const std::vector<BeamTarget>& visible,
                                            Random& random) {
  const core::SonarParams& params = sonar.params;
  std::vector<SonarReturn> returns;
  for (const auto& target : visible) {
    if (random.bernoulli(*params.miss_probability)) continue;
    const double range = target.range + random.gaussian(sonar.echo_range_sigma);
    const double bearing = target.bearing + random.gaussian(params.bearing_sigma_or_default());
    if (in_range(params, range)) returns.push_back({core::wrap_to_pi(bearing), range, 1.0});
  }
  for (int left = random.poisson(*params.clutter_per_scan); left > 0; --left) {
    const double bearing = core::wrap_to_pi(random.uniform(params.left_edge(), params.right_edge()));
    returns.push_back({bearing, params.max_range - random.uniform(0.0, params.max_range), 1.0});
  }
  std::sort(returns.begin(), returns.end(),
            [](const auto& a, const auto& b) { return a.bearing < b.bearing; });
  return returns;
}

}  // namespace lookout::sonar_sim
