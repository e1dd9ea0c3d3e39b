#pragma once

#include <vector>

#include "tracking/metrics/trajectories.hpp"

namespace lookout::tracking {

/// What trajectory GOSPA counts as on a target, and at what price.
struct TrajectoryGospaParams {
  double cutoff = 20.0;  ///< Largest distance at which a track is on a target [m], > 0, finite.
  double order = 2.0;    ///< Order p, in [1, inf).
  double switch_penalty =
      2.0;  ///< Price gamma of a target's change from one track to another [m], > 0, finite.
};

/// What one time adds, in units of cutoff^p.
struct TrajectoryGospaStep {
  double localization = 0.0;  ///< Sum over the pairs of (distance / cutoff)^p.
  int missed = 0;             ///< Targets without a track, each 1/2.
  int false_tracks = 0;       ///< Tracks without a target, each 1/2.
  double switches = 0.0;  ///< Changes of track since the time before; a change to or from none is half a one.

  /// Adds another's parts to these.
  TrajectoryGospaStep& operator+=(const TrajectoryGospaStep& other);
};

/// The distance of two sets of trajectories and its parts: total^p = localization^p + missed^p +
/// false_tracks^p + switches^p. All are of the whole run; total / num_times^(1/p) compares runs of different
/// lengths.
struct TrajectoryGospaResult {
  double total = 0.0, localization = 0.0, missed = 0.0, false_tracks = 0.0, switches = 0.0;  ///< [m]
  double num_switches = 0.0;               ///< Changes of track; a change to or from none is half a one.
  std::vector<TrajectoryGospaStep> steps;  ///< One a time.
};

/// Trajectory GOSPA: GOSPA at each time (alpha = 2) with the pairs of target and track chosen over the whole
/// run, each change of pairs at a price. The metric of multidimensional assignment, not its
/// linear-programming bound. [GarciaFernandez2020].
///
/// Exact by dynamic programming over the pairs, in groups of trajectories that ever come within the cut-off.
/// Where more than kMostStates pairings of a group stay open at one time, kMostPairings are possible, or all
/// of them take more than kMostWork, it gives up.
class TrajectoryGospa {
 public:
  static constexpr std::size_t kMostStates = 400;        ///< Pairings kept open at one time.
  static constexpr std::size_t kMostPairings = 500'000;  ///< Tried at one time.
  static constexpr double kMostWork = 5e8;               ///< Of all times of a group [steps]: some seconds.

  /// @throws std::invalid_argument on a parameter out of range.
  explicit TrajectoryGospa(const TrajectoryGospaParams& params = {});

  /// @throws std::length_error where a group has too many open pairings.
  TrajectoryGospaResult operator()(const TrajectorySet& truth, const TrajectorySet& estimate) const;

  /// [m] of the parts that a step states.
  double total(const TrajectoryGospaStep& step) const;

 private:
  TrajectoryGospaParams params_;
};

}  // namespace lookout::tracking
