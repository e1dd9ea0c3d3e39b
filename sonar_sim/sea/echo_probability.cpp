#include "sonar_sim/sea/echo_probability.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::sonar_sim {
namespace {

double cos_aspect(const Ping& ping, const core::TargetTruth& target) {
  const Eigen::Vector2d p_sonar{ping.T_earth_sonar.north, ping.T_earth_sonar.east};
  const Eigen::Vector2d sight = target.position - p_sonar;
  const double lengths = sight.norm() * target.velocity.norm();
  return lengths > 0.0 ? sight.dot(target.velocity) / lengths : 0.0;
}

}  // namespace

double miss_probability(const EchoProbability& plan, double p_miss, double range, double cos_aspect) {
  const double by_range = plan.range_loss * std::pow(range / *plan.reference_range, plan.range_exponent);
  return std::min(1.0, p_miss + by_range + plan.aspect_loss * cos_aspect * cos_aspect);
}

void weaken(const EchoProbability& plan, const Ping& ping, const core::GroundTruth& truth,
            std::vector<BeamTarget>& targets) {
  for (auto& target : targets)
    target.miss_probability = miss_probability(plan, *ping.params.miss_probability, target.range,
                                               cos_aspect(ping, truth.targets[target.target]));
}

}  // namespace lookout::sonar_sim
