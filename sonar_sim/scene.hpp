#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_params.hpp"
#include "sonar_sim/image_model.hpp"
#include "sonar_sim/target_motion.hpp"
#include "sonar_sim/vehicle_motion.hpp"

/// A scene: who moves how, and what the sonars are like. Read from YAML (tools/scenarios/).
namespace lookout::sonar_sim {

/// How false alarms are drawn; docs/symbols.md has both in formulas.
enum class ClutterReading {
  literal,  ///< Each beam without a target alarms with P_F.
  light     ///< A Poisson number, in proportion to the expected detections, in beams without a target.
};

/// One sonar: what the estimators may be told of it, and what only the simulator knows.
struct SonarPlan {
  core::SonarParams params;  ///< Both probabilities (or clutter_per_scan and miss_probability) are set.
  ClutterReading clutter = ClutterReading::literal;  ///< Which reading of the paper's false alarms.
  double echo_range_sigma =
      3.0;  ///< True standard deviation of a range [m], >= 0; usually params.range_sigma.
  bool quantise_bearing = true;  ///< Report a target at its beam's centre; off: at its true bearing.
};

/// One vehicle with its sonar.
struct PlatformPlan {
  std::string channel_prefix;      ///< Of its LCM channels, e.g. "AUV1_".
  std::int32_t node_id = 1;        ///< Of its tracker; unique in the scene.
  VehiclePlan vehicle;             ///< How it moves, and what its navigation gets wrong.
  SonarPlan sonar;                 ///< What it carries.
  std::optional<ImagePlan> image;  ///< Where the scene asks for raw images beside the scans.
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

/// How many scans the platform's sonar makes.
int num_scans(const Scene& scene, const PlatformPlan& platform);

/// The scheduled targets at `time` [s], `visible` as seen from the platform's sonar at its true pose.
core::GroundTruth truth_at(const Scene& scene, const PlatformPlan& platform, const VehicleMotion& motion,
                           double time);

/// Mean number of visible targets over the platform's scans.
double mean_visible_targets(const Scene& scene, const PlatformPlan& platform);

/// What an estimator that knows the sensor is told: the params, and under light clutter the false-alarm
/// probability per empty beam with the same mean, P_F / (1 - P_F) (1 - P_M) n / (num_beams - n), n the mean
/// visible targets.
core::SonarParams known_params(const Scene& scene, const PlatformPlan& platform);

}  // namespace lookout::sonar_sim
