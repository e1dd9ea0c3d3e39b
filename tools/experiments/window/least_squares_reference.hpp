#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// The straight course of one target as least squares on its own detections gives it.
struct ReferenceFit {
  std::int32_t id = 0;
  int detections = 0;
  Eigen::Vector4d state{0, 0, 0, 0};  ///< North, east [m] at the newest scan, north and east velocity [m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
};

/// What perfect association reaches on the same scans: each target that is visible in the newest scan, fitted
/// to the detections that are truly its own, occlusion and misses as they were. Targets whose detections do
/// not fix a course are left out. Beam sonars only: a beam that holds a target reports that target or
/// nothing.
std::vector<ReferenceFit> least_squares_reference(std::span<const TimedScan> scans,
                                                  const core::SonarParams& sonar);

}  // namespace lookout::tools
