#include "sonar_sim/beam_model.hpp"

#include <algorithm>
#include <tuple>

#include "core/field_of_view.hpp"

namespace lookout::sonar_sim {

std::vector<BeamTarget> visible_targets(const Ping& ping, const core::GroundTruth& truth) {
  std::vector<BeamTarget> targets;
  for (std::size_t i = 0; i < truth.targets.size(); ++i) {
    const auto point = core::observe(ping.params, ping.T_earth_sonar, truth.targets[i].position);
    if (point.visible())
      targets.push_back({ping.params.beam_of(point.bearing), point.range, point.bearing, i});
  }
  std::sort(targets.begin(), targets.end(), [](const BeamTarget& a, const BeamTarget& b) {
    return std::tie(a.beam, a.range) < std::tie(b.beam, b.range);
  });
  return targets;
}

std::vector<BeamTarget> beam_owners(const std::vector<BeamTarget>& visible, int returns_per_beam) {
  std::vector<BeamTarget> owners;
  int in_beam = 0;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    in_beam = i > 0 && visible[i].beam == visible[i - 1].beam ? in_beam + 1 : 1;
    if (in_beam <= returns_per_beam) owners.push_back(visible[i]);
  }
  return owners;
}

}  // namespace lookout::sonar_sim
