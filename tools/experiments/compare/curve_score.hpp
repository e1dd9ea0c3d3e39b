#pragma once

#include <vector>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "tools/experiments/compare/curve.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tools {

/// What `compare` measures with.
struct CurveScoreParams {
  tracking::OspaParams ospa;  ///< Cut-off and order of all metrics; the cut-off is the gate of pairs too.
  tracking::TruthKind kind = tracking::TruthKind::visible;  ///< Which targets and tracks count.
  double window = 10.0;                                     ///< How far OSPA(2) looks back [s], > 0.
  double switch_penalty = 2.0;                              ///< Of trajectory GOSPA [m], > 0.
};

/// Degrees of freedom of a track's state, and so of its NEES.
inline constexpr int kNeesDimensions = 4;

/// All columns of a run but the processor time, rounded.
/// @param truth, tracks index by index, in order of time. Where trajectory GOSPA has too many open pairings
/// its columns are empty.
/// @throws std::invalid_argument on parameters out of range.
Curve score_curve(const std::vector<core::GroundTruth>& truth,
                  const std::vector<std::vector<core::Track>>& tracks, const CurveScoreParams& params);

}  // namespace lookout::tools
