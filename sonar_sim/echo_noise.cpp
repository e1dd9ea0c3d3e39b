#include "sonar_sim/echo_noise.hpp"

#include <algorithm>

namespace lookout::sonar_sim {
namespace {

using core::Random;

bool missed(const Ping& ping, const BeamTarget& target, Random& random) {
  return random.bernoulli(target.miss_probability.value_or(*ping.params.miss_probability));
}

double noisy_range(const Ping& ping, const BeamTarget& target, Random& random) {
  return target.range + target.noise_scale * random.gaussian(ping.echo_range_sigma);
}

BeamReturn echo_of(const BeamTarget& target, int beam, double bearing, double range) {
  return {beam, {bearing, range, 1.0}, Source::target, static_cast<int>(target.target), target.snr_db};
}

double draw_clutter_range(const Ping& ping, Random& random) {
  // max_range minus a draw of [0, max_range) lies in (0, max_range].
  return ping.params.max_range - random.uniform(0.0, ping.params.max_range);
}

BeamReturn draw_false_alarm(const Ping& ping, int beam, Random& random) {
  return {beam, {ping.params.beam_centre(beam), draw_clutter_range(ping, random), 1.0}};
}

/// The beam of each slot that no target owns.
std::vector<int> empty_slots(const Ping& ping, const std::vector<BeamTarget>& owners) {
  std::vector<int> slots;
  auto owner = owners.begin();
  for (int beam = 0; beam < ping.params.num_beams; ++beam) {
    int free = ping.returns_per_beam;
    for (; owner != owners.end() && owner->beam == beam; ++owner) --free;
    slots.insert(slots.end(), static_cast<std::size_t>(free), beam);
  }
  return slots;
}

/// The mean number of false alarms under light clutter: P_F / (1 - P_F) for each expected detection.
double light_mean(const core::SonarParams& params, int num_visible) {
  const double p_f = *params.false_alarm_probability;
  return p_f / (1.0 - p_f) * num_visible * (1.0 - *params.miss_probability);
}

std::vector<BeamReturn> draw_literal_clutter(const Ping& ping, const std::vector<int>& slots,
                                             Random& random) {
  std::vector<BeamReturn> alarms;
  for (const int beam : slots) {
    if (random.bernoulli(*ping.params.false_alarm_probability))
      alarms.push_back(draw_false_alarm(ping, beam, random));
  }
  return alarms;
}

std::vector<BeamReturn> draw_light_clutter(const Ping& ping, std::vector<int> slots, int num_visible,
                                           Random& random) {
  std::vector<BeamReturn> alarms;
  for (int left = random.poisson(light_mean(ping.params, num_visible)); left > 0 && !slots.empty(); --left) {
    const auto pick = slots.begin() + random.index(static_cast<int>(slots.size()));
    alarms.push_back(draw_false_alarm(ping, *pick, random));
    slots.erase(pick);
  }
  return alarms;
}

}  // namespace

std::vector<BeamReturn> draw_beam_echoes(const Ping& ping, const std::vector<BeamTarget>& owners,
                                         Random& random) {
  std::vector<BeamReturn> echoes;
  for (const auto& owner : owners) {
    if (missed(ping, owner, random)) continue;
    const double range = noisy_range(ping, owner, random);
    if (ping.in_range(range))
      echoes.push_back(echo_of(owner, owner.beam, ping.reported_bearing(owner.beam, owner.bearing), range));
  }
  return echoes;
}

std::vector<BeamReturn> draw_beam_clutter(const Ping& ping, const std::vector<BeamTarget>& owners,
                                          int num_visible, Random& random) {
  std::vector<int> slots = empty_slots(ping, owners);
  return ping.clutter == ClutterReading::literal
             ? draw_literal_clutter(ping, slots, random)
             : draw_light_clutter(ping, std::move(slots), num_visible, random);
}

std::vector<BeamReturn> draw_point_echoes(const Ping& ping, const std::vector<BeamTarget>& visible,
                                          Random& random) {
  std::vector<BeamReturn> echoes;
  for (const auto& target : visible) {
    if (missed(ping, target, random)) continue;
    const double range = noisy_range(ping, target, random);
    const double bearing = target.bearing + random.gaussian(ping.params.bearing_sigma_or_default());
    if (ping.in_range(range))
      echoes.push_back(echo_of(target, target.beam, core::wrap_to_pi(bearing), range));
  }
  return echoes;
}

std::vector<BeamReturn> draw_point_clutter(const Ping& ping, Random& random) {
  const core::SonarParams& params = ping.params;
  std::vector<BeamReturn> alarms;
  for (int left = random.poisson(*params.clutter_per_scan); left > 0; --left) {
    const double bearing = core::wrap_to_pi(random.uniform(params.left_edge(), params.right_edge()));
    alarms.push_back({ping.params.beam_of(bearing), {bearing, draw_clutter_range(ping, random), 1.0}});
  }
  return alarms;
}

}  // namespace lookout::sonar_sim
