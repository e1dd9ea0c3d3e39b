#pragma once

#include <cstdint>
#include <vector>

#include "tracking/joint_cloud.hpp"

namespace lookout::tracking {

/// One target that may exist: a density over its trajectory and the odds that it is there.
struct JointTrack {
  bool used = false;  ///< The slot holds a track.
  std::int64_t id = 0;
  JointCloud cloud;
  CloudMoments moments;         ///< Of the cloud.
  double log_odds = 0.0;        ///< Of existence.
  double log_density = 0.0;     ///< ln of the prior density it was born with.
  double visible_share = 1.0;   ///< Probability that it is in the field of view, if it exists.
  double echo_share = 0.0;      ///< Probability that the newest scan holds an echo of it, if it exists.
  std::int64_t first_scan = 0;  ///< Number of the scan since which its likelihood counts.
  std::int64_t first_utime = 0;
  std::int64_t last_detection_utime = 0;
  std::int64_t out_of_view_utime = 0;  ///< Since when it is outside the field of view, while it is.
  bool out_of_view = false;
  bool reported = false;  ///< Part of the newest report.
  bool confirmed_once = false;
  bool has_claims = false;        ///< On scans before the newest.
  bool claims_filled = false;     ///< They are those of the present cloud.
  std::vector<double> log_ratio;  ///< Of the newest scan, trajectory by trajectory.

  double existence() const;
};

/// Probability of log odds.
double probability(double log_odds);

}  // namespace lookout::tracking
