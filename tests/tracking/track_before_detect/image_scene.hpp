#pragma once

#include <string>
#include <vector>

#include "sonar_sim/sonar_simulator.hpp"

namespace lookout::tracking {

/// A still sonar at the origin that looks north, with the given targets and background of shape 4.
inline sonar_sim::Scene sonar_scene(const std::string& targets, double duration = 30.0,
                                    double snr_db = 12.0) {
  return sonar_sim::parse_scene("duration: " + std::to_string(duration) +
                                    "\nsonar: {miss_probability: 0.3, false_alarm_probability: 0.05}\n"
                                    "image: {snr_db: " +
                                    std::to_string(snr_db) + "}\n" +
                                    (targets.empty() ? "" : "targets:\n" + targets),
                                "scene");
}

/// The pings of a scene with the sonar's true pose.
inline std::vector<core::PosedImage> pings_of(const sonar_sim::Scene& scene, std::uint64_t seed) {
  sonar_sim::SonarSimulator simulator(scene, seed);
  std::vector<core::PosedImage> pings;
  while (const auto ping = simulator.next()) pings.push_back({*ping->image, ping->T_earth_sonar});
  return pings;
}

}  // namespace lookout::tracking
