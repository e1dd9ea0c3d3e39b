#pragma once

#include <vector>

#include "core/motion_element.hpp"
#include "core/sonar_params.hpp"
#include "csht/motion_estimator.hpp"
#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// What an estimator says of a window's newest scan, and what that scan took.
struct WindowAnswer {
  std::vector<core::MotionElement> elements;
  double time_ms = 0.0;  ///< Of the newest scan alone.
};

/// Gives the window's scans to the estimator, the oldest first.
WindowAnswer estimate_window(csht::MotionEstimator& estimator, const std::vector<TimedScan>& scans);

/// The figures of one window: OSPA of position and velocity, whether the count is right (and then the
/// velocity's OSPA and NEES), and the perfect association on the same scans (`bound`, `velocity_bound`).
Metrics score_window(const std::vector<TimedScan>& scans, const core::SonarParams& sonar,
                     const WindowAnswer& answer);

}  // namespace lookout::tools
