#pragma once

#include <span>
#include <vector>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tracking/metrics/track_quality.hpp"

/// How tracks on the labelled boats of a radar recording are scored.
namespace lookout::tools {

/// The tracks of every scan, index by index with the scans.
using TracksOfScans = std::vector<std::vector<core::Track>>;

/// What counts as near a boat, and as a silence of it.
struct BoatScoreParams {
  double gate = 20.0;    ///< A track farther than this from a boat is not on it [m], > 0.
  double reach = 40.0;   ///< Of the confirmed tracks those this near to a boat in sight count for OSPA [m], >
                         ///< 0: farther ones may be on things that are real and have no label.
  double radius = 15.0;  ///< A return as near as this to a boat may be its own [m], > 0.
  int silent_scans = 3;  ///< Scans in a row without such a return that are a silence, >= 1.
};

/// Whether the scan has a return within `radius` [m] of a place (earth frame).
bool heard_near(const core::PosedScan& scan, const Eigen::Vector2d& p_earth, double radius);

/// How the boats in sight were followed: `followed_share`, `identities` and `median_error_m`, for each boat
/// too with the suffix `_target` and its id, `identity_switches` and `mean_tracks`.
Metrics follow_metrics(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                       const BoatScoreParams& params);

/// Mean OSPA (cut-off 20 m, order 2) over the scans with a boat in sight, of the confirmed tracks near one
/// [m].
double ospa_near(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                 const BoatScoreParams& params);

/// `excess_error_m`: median error of these tracks less that of a rival's, over the scans in which a track of
/// either is on the boat [m]; for each boat, with the suffix `_target` and its id, and the mean over the
/// boats.
Metrics excess_errors(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                      const TracksOfScans& rival, const BoatScoreParams& params);

/// `silences`: how often a boat that a confirmed track is on falls silent for `silent_scans`;
/// `silence_kept_share`: in which of them the track is still confirmed at the last, without a value where
/// there was none.
Metrics silences(const std::vector<TimedScan>& scans, const TracksOfScans& tracks,
                 const BoatScoreParams& params);

}  // namespace lookout::tools
