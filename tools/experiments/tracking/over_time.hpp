#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"

namespace lookout::tools {

/// OSPA of one scan of one run, targets in view [m], and the numbers behind it.
struct ScoredScan {
  std::int64_t utime = 0;  ///< Of the scan [us].
  double total = 0.0;      ///< [m].
  double localization = 0.0;
  double cardinality = 0.0;
  int num_truth = 0;
  int num_tracks = 0;
};
using ScoredScans = std::vector<ScoredScan>;

/// A run scored scan by scan against the targets in view.
ScoredScans score_scans(const std::vector<TimedScan>& scans, const TrackingOutput& output);

/// Writes the means over the runs, a row a scan, each part with the half width of its 95 % interval over the
/// runs: `time_s,total,total_ci95,localization,localization_ci95,cardinality,cardinality_ci95,num_truth,
/// num_tracks`; an interval is empty from a single run.
/// @param runs not empty, all of the same scan times.
void write_mean_over_time(const std::vector<ScoredScans>& runs, const std::string& path);

}  // namespace lookout::tools
