#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_params.hpp"
#include "sonar_sim/image_model.hpp"
#include "sonar_sim/ping.hpp"
#include "sonar_sim/return_selection.hpp"
#include "sonar_sim/sea/sea_plan.hpp"
#include "sonar_sim/target_motion.hpp"
#include "sonar_sim/vehicle_motion.hpp"

/// A scene: who moves how, and what the sonars are like. Read from YAML (tools/scenarios/).
namespace lookout::sonar_sim {

/// A switch of the sonar's range by its operator.
struct RangeSetting {
  double time = 0.0;       ///< From then on [s], > 0.
  double max_range = 0.0;  ///< [m], > 0.
};

/// One sonar: what the estimators may be told of it, and what only the simulator knows.
struct SonarPlan {
  core::SonarParams params;  ///< Both probabilities (or clutter_per_scan and miss_probability) are set.
  ClutterReading clutter = ClutterReading::literal;  ///< Which reading of the paper's false alarms.
  double echo_range_sigma =
      3.0;  ///< True standard deviation of a range [m], >= 0; usually params.range_sigma.
  bool quantise_bearing = true;           ///< Report a target at its beam's centre; off: at its true bearing.
  std::optional<std::int32_t> sensor_id;  ///< Absent: the vehicle's node_id, counted up over its sonars.
  double first_scan = 0.0;                ///< Time of the first ping [s], >= 0.
  std::vector<RangeSetting> range_settings;  ///< In order of time; params.max_range holds before the first.
  int returns_per_beam = 1;                  ///< Most returns of one beam, >= 1.
  Keep keep = Keep::precedence;              ///< Which those are.
  SeaPlan sea;                               ///< What it meets beyond the paper's sea.
};

/// One vehicle with its sonar or sonars.
struct PlatformPlan {
  std::string channel_prefix;             ///< Of its LCM channels, e.g. "AUV1_".
  std::int32_t node_id = 1;               ///< Of its tracker; unique in the scene.
  VehiclePlan vehicle;                    ///< How it moves, and what its navigation gets wrong.
  SonarPlan sonar;                        ///< The first.
  std::vector<SonarPlan> further_sonars;  ///< On the same vehicle and channels, told apart by sensor_id.
  std::optional<ImagePlan> image;         ///< Where the scene asks for raw images beside the first's scans.
};

/// Everything that is simulated: for how long, with which vehicles, and what moves around them.
struct Scene {
  double duration = 0.0;                ///< Scans at 0, period, 2 period, ... < duration [s].
  std::vector<PlatformPlan> platforms;  ///< At least one.
  std::vector<TargetPlan> targets;      ///< May be empty: an empty sea.
};

/// @throws core::InputError naming file, line, column and key.
Scene load_scene(const std::string& path);
/// The same from text; `name` stands for the file in messages.
Scene parse_scene(const std::string& text, const std::string& name);

/// The platform's sonars, the first first. They point into `platform`.
std::vector<const SonarPlan*> all_sonars(const PlatformPlan& platform);

/// The sonar's params under the range setting of `time` [s].
core::SonarParams params_at(const SonarPlan& sonar, double time);

/// How many scans the sonar makes, lost ones counted; all sonars of the platform.
int num_scans(const Scene& scene, const SonarPlan& sonar);
/// Scans that a sonar makes in the scene.
int num_scans(const Scene& scene, const PlatformPlan& platform);

/// The scheduled targets at `time` [s], `visible` where one of the platform's sonars at its true pose has
/// them in its sector and range.
core::GroundTruth truth_at(const Scene& scene, const PlatformPlan& platform, const VehicleMotion& motion,
                           double time);

/// Mean number of visible targets over the scans of the platform's first sonar.
double mean_visible_targets(const Scene& scene, const PlatformPlan& platform);

/// What an estimator that knows the sensor is told: the params, and under light clutter the false-alarm
/// probability per empty beam with the same mean, P_F / (1 - P_F) (1 - P_M) n / (num_beams - n), n the mean
/// visible targets.
core::SonarParams known_params(const Scene& scene, const PlatformPlan& platform);

}  // namespace lookout::sonar_sim
