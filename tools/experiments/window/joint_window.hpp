#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// Writes what the joint estimator makes of one window, step by step, for a picture: joint_detections.csv
/// (time_s,north_m,east_m), joint_truth.csv, joint_clouds.csv and joint_hypotheses.csv
/// (north_m,east_m,north_velocity_mps,east_velocity_mps,weight) and joint_elements.csv. The weight is the
/// probability of a trajectory and the log odds of a hypothesis [nats]; states at the newest scan.
void write_joint_window(const std::vector<TimedScan>& scans, const core::SonarParams& sonar,
                        std::uint64_t seed, const std::string& directory);

/// The detections of a window in the earth frame, time_s,north_m,east_m.
void write_detections(const std::vector<TimedScan>& scans, const std::string& path);

}  // namespace lookout::tools
