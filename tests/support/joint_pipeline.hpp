#pragma once

#include <cstdint>
#include <memory>

#include "csht/joint/joint_estimator.hpp"
#include "tracking/joint/joint_tracker.hpp"
#include "tracking/scan_pipeline.hpp"

namespace lookout::tracking {

/// The joint tracker with these parameters, begun on what the joint estimator finds beyond its tracks.
inline ScanPipeline joint_pipeline(const core::SonarParams& sonar, std::uint64_t seed = 1,
                                   const JointTrackerParams& params = {}) {
  csht::JointEstimatorParams estimator;
  estimator.engine = params;
  return {std::make_unique<csht::JointEstimator>(estimator, sonar, seed),
          std::make_unique<JointTracker>(params, sonar, seed)};
}

}  // namespace lookout::tracking
