#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/track.hpp"
#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tools {

/// What a tracker reported at every scan, and its processor time.
struct TrackingOutput {
  /// Index by index with the scans; fewer under delayed output, whose last scans have no answer in time.
  std::vector<std::vector<core::Track>> tracks;
  std::vector<double> times_ms;  ///< Processor time of each update [ms],
  double time_ms = 0.0;          ///< and their mean.
};

/// The seed of a tracker in one run of an experiment, of a stream that the simulator does not use.
std::uint64_t run_seed(std::uint64_t seed, int run);

/// The pipeline of a tracker and the estimator that it has by default.
std::unique_ptr<tracking::ScanPipeline> pipeline_of(const std::string& tracker,
                                                    const core::SonarParams& sonar, std::uint64_t seed);

/// Runs a pipeline over all scans of a run.
/// @param lag_s how long after a scan its tracks are asked for [s]; above 0 of trackers that can retrodict.
TrackingOutput track(tracking::ScanPipeline& pipeline, const std::vector<TimedScan>& scans,
                     double lag_s = 0.0);

/// All metrics of the tracking experiments: OSPA and its parts against the visible truth (`ospa_schedule`
/// against the schedule), GOSPA and its parts, and how the targets were followed.
Metrics score(const std::vector<TimedScan>& scans, const TrackingOutput& output);

}  // namespace lookout::tools
