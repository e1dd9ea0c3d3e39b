#include "tools/experiments/initiation/sonar_initiation_scene.hpp"

#include <map>

#include "core/frames.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/sonar_plots.hpp"

namespace lookout::tools {
namespace {

constexpr double kTruthGate = 0.999;  // Share of a target's own plots inside the gate.
constexpr double kLeastView = 5.0;    // A target seen for less cannot fill a window [s].

/// The number of each target that is in view for long enough.
std::map<std::int32_t, int> numbered_targets(const std::vector<TimedScan>& scans, double period) {
  std::map<std::int32_t, int> scans_in_view, numbers;
  for (const TimedScan& scan : scans) {
    for (const auto& target : scan.truth.targets) scans_in_view[target.id] += target.visible ? 1 : 0;
  }
  for (const auto& [id, count] : scans_in_view) {
    if (count * period >= kLeastView) numbers.emplace(id, static_cast<int>(numbers.size()));
  }
  return numbers;
}

/// Whose plot it is: the nearest target's within the gate, or -1.
int target_of(const tracking::Plot& plot, const Eigen::Vector2d& p_earth_origin,
              const core::GroundTruth& truth, const std::map<std::int32_t, int>& numbers) {
  static const double gate = tracking::chi_square_gate(kTruthGate, 2);
  double least = gate;
  int nearest = -1;
  for (const auto& target : truth.targets) {
    const auto number = numbers.find(target.id);
    if (!target.visible || number == numbers.end()) continue;
    const double distance =
        tracking::squared_distance(plot.position + p_earth_origin - target.position, plot.noise);
    if (distance > least) continue;
    least = distance;
    nearest = number->second;
  }
  return nearest;
}

}  // namespace

SonarInitiation sonar_initiation(const std::string& scene_file, const SceneVariant& variant,
                                 std::uint64_t seed, int run) {
  const sonar_sim::Scene scene = load_variant(scene_file, variant);
  SonarInitiation result;
  result.sonar = scene.platforms.front().sonar.params;
  const std::vector<TimedScan> scans = simulate(scene, seed, run);
  const auto numbers = numbered_targets(scans, result.sonar.scan_period);
  result.scene.num_targets = static_cast<int>(numbers.size());
  tracking::SonarPlots sonar_plots;
  for (const TimedScan& scan : scans) {
    result.scene.times.push_back(core::seconds(scan.posed.scan.utime));
    auto& plots = result.scene.scans.emplace_back();
    for (tracking::Plot plot : sonar_plots.of(scan.posed, result.sonar)) {
      plot.source = static_cast<int>(result.scene.target_of.size());
      result.scene.target_of.push_back(target_of(plot, sonar_plots.p_earth_origin(), scan.truth, numbers));
      plots.push_back(plot);
    }
  }
  return result;
}

}  // namespace lookout::tools
