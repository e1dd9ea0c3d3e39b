#pragma once

#include <cstdint>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/sonar_scan.hpp"
#include "sonar_sim/scene.hpp"

namespace lookout::tools {

/// One scan as an estimator receives it, beside the truth.
struct TimedScan {
  core::PosedScan posed;    ///< At the pose that navigation reports, interpolated.
  core::GroundTruth truth;  ///< `visible` at the true pose.
};

/// All scans of one Monte Carlo run; scans for which navigation gives no pose are left out.
std::vector<TimedScan> simulate(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                std::size_t platform = 0);

/// The same, posed by the intake of the live chain: reports reach it when they arrive, and scans without
/// poses on either side in time are left out.
std::vector<TimedScan> simulate_through_intake(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                               std::size_t platform = 0);

/// Loads a scene of tools/scenarios by file name, with both probabilities and sigma replaced.
struct SceneVariant {
  double p_false_alarm = 0.3;
  double p_miss = 0.3;
  double sigma = 3.0;  ///< [m], of the detections and as told.
  sonar_sim::ClutterReading clutter = sonar_sim::ClutterReading::literal;
};
sonar_sim::Scene load_variant(const std::string& scene_file, const SceneVariant& variant);

/// The same scene begun `seconds` earlier (later, where negative): what it shows at its end stays as it was,
/// so that windows of any length end alike.
/// @throws std::invalid_argument for a scene with several platforms, or in which something does not move
///   straight.
void begin_earlier(double seconds, sonar_sim::Scene& scene);

/// "literal" or "light" as a reading, as parameters name it.
sonar_sim::ClutterReading clutter_reading(const std::string& name);

}  // namespace lookout::tools
