#include "tools/cli/sonar_views.hpp"

#include "core/field_of_view.hpp"
#include "tools/cli/configuration.hpp"

namespace lookout::tools {
namespace {

std::string folder_of(const char* what, bool alone, std::int32_t id) {
  return alone ? std::string() : std::string("/").append(what).append(std::to_string(id));
}

}  // namespace

std::vector<SonarView> sonar_views(const sonar_sim::Scene& scene, bool first_only) {
  std::vector<SonarView> views;
  for (std::size_t index = 0; index < scene.platforms.size(); ++index) {
    const sonar_sim::PlatformPlan& platform = scene.platforms[index];
    const auto sonars = all_sonars(platform);
    const std::string vehicle = folder_of("node", scene.platforms.size() == 1, platform.node_id);
    for (std::size_t i = 0; i < (first_only ? 1 : sonars.size()); ++i) {
      SonarView view{index, platform, vehicle};
      view.seen.sonar = *sonars[i];
      view.seen.further_sonars.clear();
      view.seen.sonar.sensor_id =
          sonars[i]->sensor_id.value_or(platform.node_id + static_cast<std::int32_t>(i));
      view.folder += folder_of("sonar", sonars.size() == 1, *view.seen.sonar.sensor_id);
      views.push_back(std::move(view));
    }
  }
  return views;
}

core::SonarParams told_params(const sonar_sim::Scene& scene, const sonar_sim::PlatformPlan& seen,
                              const Options& options) {
  const core::SonarParams known =
      options.unknown_sensor ? core::SonarParams{} : sonar_sim::known_params(scene, seen);
  const core::SonarParams& plan = seen.sonar.params;
  core::SonarParams told = load_configuration(options, known).sensor;
  told.num_beams = plan.num_beams;
  told.first_bearing = plan.first_bearing;
  told.bearing_step = plan.bearing_step;
  told.max_range = plan.max_range;
  told.T_body_sonar = plan.T_body_sonar;
  told.scan_period = plan.scan_period;
  return told;
}

core::GroundTruth truth_in_view(const sonar_sim::SimulatedScan& simulated,
                                const sonar_sim::SonarPlan& sonar) {
  const core::SonarParams params = core::with_geometry_of(simulated.scan, sonar.params);
  core::GroundTruth truth = simulated.truth;
  for (auto& target : truth.targets)
    target.visible = core::observe(params, simulated.T_earth_sonar, target.position).visible();
  return truth;
}

}  // namespace lookout::tools
