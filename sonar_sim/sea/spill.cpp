#include "sonar_sim/sea/spill.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace lookout::sonar_sim {
namespace {

bool spills(const Spill& spill, const BeamReturn& heard) {
  return heard.source == Source::target || (spill.standing && heard.source == Source::standing);
}

bool all_round(const core::SonarParams& params) {
  const double gap = 2.0 * std::numbers::pi - params.sector();
  return gap < 0.5 * params.bearing_step;
}

/// The beam `offset` beams from `beam`, or nothing beyond the edge of the fan.
std::optional<int> neighbour(const Ping& ping, int beam, int offset) {
  const int count = ping.params.num_beams;
  const int other = beam + offset;
  if (all_round(ping.params))
    return std::abs(offset) < count ? std::optional((other + count) % count) : std::nullopt;
  return other >= 0 && other < count ? std::optional(other) : std::nullopt;
}

/// Bearing of what is heard `offset` beams beside a return [rad]: as far from that beam's centre.
double bearing_beside(const Ping& ping, const BeamReturn& first, int beam, int offset) {
  const core::SonarParams& params = ping.params;
  if (!params.fan) return first.measured.bearing + offset * params.bearing_step;
  return first.measured.bearing + params.beam_centre(beam) - params.beam_centre(first.beam);
}

std::optional<BeamReturn> repeat(const Spill& spill, const Ping& ping, const BeamReturn& first, int offset,
                                 core::Random& random) {
  const auto index = static_cast<std::size_t>(std::abs(offset)) - 1;
  const auto beam = neighbour(ping, first.beam, offset);
  if (!beam || !random.bernoulli(spill.probabilities[index])) return std::nullopt;
  BeamReturn heard = first;
  heard.beam = *beam;
  heard.source = Source::spill;
  heard.loss_db = index < spill.loss_db.size() ? spill.loss_db[index] : 0.0;
  const double bearing = bearing_beside(ping, first, *beam, offset);
  heard.measured.bearing = ping.reported_bearing(*beam, core::wrap_to_pi(bearing));
  heard.measured.range += random.gaussian(spill.range_sigma);
  return ping.in_range(heard.measured.range) ? std::optional(heard) : std::nullopt;
}

}  // namespace

std::vector<BeamReturn> draw_spill(const Spill& spill, const Ping& ping, const std::vector<BeamReturn>& heard,
                                   core::Random& random) {
  const int reach = static_cast<int>(spill.probabilities.size());
  std::vector<BeamReturn> repeated;
  for (const auto& first : heard) {
    if (!spills(spill, first)) continue;
    for (int offset = -reach; offset <= reach; ++offset) {
      if (offset == 0) continue;
      if (const auto other = repeat(spill, ping, first, offset, random)) repeated.push_back(*other);
    }
  }
  return repeated;
}

}  // namespace lookout::sonar_sim
