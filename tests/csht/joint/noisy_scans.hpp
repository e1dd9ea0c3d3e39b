#pragma once

#include <vector>

#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/straight_scene.hpp"

namespace lookout::csht::testing {

/// A history that holds these scans.
inline ScanHistory history_of(const std::vector<core::PosedScan>& scans, const SensorFigures& figures) {
  ScanHistory history(figures, {}, static_cast<int>(scans.size()));
  for (const auto& scan : scans) history.push(scan);
  return history;
}

/// Scans of courses through the literal sonar's errors: sigma 3 m, beams of one degree.
inline std::vector<core::PosedScan> noisy_scans(const std::vector<Course>& courses, int num_scans,
                                                int clutter_per_scan, std::uint64_t seed) {
  core::Random random(seed);
  return scans_of(courses, num_scans,
                  {.range_sigma = 3.0, .quantise = true, .p_miss = 0.1, .clutter_per_scan = clutter_per_scan},
                  random);
}

/// Figures that fit `noisy_scans` with nine false alarms a scan.
inline SensorFigures noisy_figures() {
  return {.miss_probability = 0.1,
          .false_alarm_probability = 0.1,
          .range_sigma = 3.0,
          .bearing_sigma = sonar().bearing_sigma_or_default()};
}

}  // namespace lookout::csht::testing
