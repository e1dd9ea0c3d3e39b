#include "sonar_sim/beam_model.hpp"

#include <algorithm>
#include <tuple>

#include "core/field_of_view.hpp"

namespace lookout::sonar_sim {

std::vector<BeamTarget> visible_targets(const core::SonarParams& params, const core::Pose2& T_earth_sonar,
                                        const core::GroundTruth& truth) {
  std::vector<BeamTarget> targets;
  for (const auto& target : truth.targets) {
    const core::SonarPoint point = core::observe(params, T_earth_sonar, target.position);
    if (point.visible()) targets.push_back({point.beam, point.range, point.bearing});
  }
  std::sort(targets.begin(), targets.end(), [](const BeamTarget& a, const BeamTarget& b) {
    return std::tie(a.beam, a.range) < std::tie(b.beam, b.range);
  });
  return targets;
}

std::vector<BeamTarget> beam_owners(std::vector<BeamTarget> visible) {
  const auto same_beam = [](const BeamTarget& a, const BeamTarget& b) { return a.beam == b.beam; };
  visible.erase(std::unique(visible.begin(), visible.end(), same_beam), visible.end());
  return visible;
}

}  // namespace lookout::sonar_sim
