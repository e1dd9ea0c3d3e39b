#pragma once

#include <vector>

#include "core/sonar_params.hpp"
#include "core/track.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {

/// The tracker that is told which detection is whose: what no tracker can beat on the same scans by more than
/// Monte Carlo error. It reports each target in view from its first detection on, as the least-squares
/// constant velocity fit to all its detections so far.
class PerfectAssociation {
 public:
  /// @param sonar sigma as it truly is.
  explicit PerfectAssociation(const core::SonarParams& sonar);

  /// The targets in view that have been detected, at the time of `scan`.
  std::vector<core::Track> update(const TimedScan& scan);

 private:
  core::SonarParams sonar_;
  std::vector<core::Track> fits_;  ///< `id` is the target's.
};

}  // namespace lookout::tools
