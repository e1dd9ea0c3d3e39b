#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/options.hpp"

namespace lookout::tools {

/// One sonar of one vehicle of a scene: what a recording holds, and what one tracker works on.
struct SonarView {
  std::size_t platform = 0;      ///< Index of the vehicle in the scene.
  sonar_sim::PlatformPlan seen;  ///< The vehicle with this sonar alone, its sensor_id set.
  std::string folder;  ///< "" of a scene with one sonar, else "/node1", "/sonar2" or "/node1/sonar2".
};

/// All sonars of a scene, vehicle by vehicle. @param first_only the first sonar of each vehicle alone.
std::vector<SonarView> sonar_views(const sonar_sim::Scene& scene, bool first_only = false);

/// What a tracker is told of the sensor: the scene's figures and over them what the configuration says; with
/// --unknown-sensor the configuration alone. The geometry is always that of the scans.
/// @throws core::InputError as `load_configuration`.
core::SonarParams told_params(const sonar_sim::Scene& scene, const sonar_sim::PlatformPlan& seen,
                              const Options& options);

/// The truth as this sonar alone sees it.
core::GroundTruth truth_in_view(const sonar_sim::SimulatedScan& simulated, const sonar_sim::SonarPlan& sonar);

}  // namespace lookout::tools
