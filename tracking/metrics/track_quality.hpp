#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "tracking/association/assignment.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tracking {

/// When a track is on a target.
struct TrackQualityParams {
  double gate = 20.0;  ///< A track farther than this from a target is not on it [m], > 0. The OSPA cut-off.
  int identity_scans = 10;  ///< Scans in a row that a track must be on a target to be its identity, >= 1:
                            ///< where two targets meet, the assignment of single scans is noise.
  TruthKind kind = TruthKind::visible;
};

/// A target and the track on it at one scan.
struct TrackOnTarget {
  core::TargetTruth target;  ///< As at the scan.
  core::Track track;         ///< As at the scan.
};

/// How one target was tracked.
struct TargetQuality {
  std::int32_t id = 0;  ///< Of the target.
  int scans = 0;        ///< In which it counted.
  int followed = 0;     ///< In which a track was on it.
  int identities = 0;   ///< Different tracks that were on it in `identity_scans` scans or more in a row.
  int switches = 0;     ///< Changes of that identity.
  double time_to_confirm = 0.0;  ///< From its first scan to its first track; without one, its whole time [s].
  std::optional<double> median_error;  ///< Of the position while followed [m].
  /// Of the scans in which it counted; 0 where there were none.
  double followed_share() const { return scans > 0 ? static_cast<double>(followed) / scans : 0.0; }
};

/// The same over a run.
struct TrackQualityResult {
  double purity = 0.0;        ///< Share of all track scans on a target that are on the track's main target.
  int identity_switches = 0;  ///< Over all targets.
  double time_to_confirm = 0.0;        ///< Mean over targets [s].
  double false_per_100s = 0.0;         ///< Tracks that are on no target for most of their scans [1/100 s].
  double count_correct = 0.0;          ///< Share of scans with as many tracks as targets.
  double followed_share = 0.0;         ///< Mean over targets.
  double identities = 0.0;             ///< Mean over targets.
  double mean_tracks = 0.0;            ///< Tracks that count, per scan.
  std::vector<TargetQuality> targets;  ///< By id.
};

/// Follows which track is on which target over a run: one-to-one per scan, the largest number of pairs within
/// the gate and among those the least sum of distances.
class TrackQuality {
 public:
  /// @throws std::invalid_argument on a gate <= 0 or identity_scans < 1.
  explicit TrackQuality(const TrackQualityParams& params = {});

  /// Takes one scan; times increase.
  void add(const core::GroundTruth& truth, std::span<const core::Track> tracks);
  TrackQualityResult result() const;  ///< Over the scans added.
  /// Which track was on which target at the newest scan; valid until the next `add`. A target keeps the track
  /// that is its identity while that is within the gate: where two targets meet, the nearest may be the
  /// other's.
  std::span<const TrackOnTarget> pairs() const { return pairs_; }

 private:
  struct Target {
    std::int64_t first_utime = 0, last_utime = 0;
    std::optional<std::int64_t> confirmed_utime;
    int scans = 0, switches = 0;
    std::int64_t current_track = 0;
    int current_run = 0;
    std::optional<std::int64_t> identity;
    std::map<std::int64_t, bool> identities;
    std::vector<double> errors;
  };
  struct TrackLife {
    int scans = 0;
    std::map<std::int32_t, int> on_target;
  };

  void select(const core::GroundTruth& truth, std::span<const core::Track> tracks);
  void keep_pairs(const std::vector<int>& track_of_target, const Eigen::MatrixXd& cost);
  void count_scan(Target& target, std::int64_t utime) const;
  void put_on(Target& target, const core::Track& track, double distance, std::int64_t utime);
  TargetQuality quality_of(std::int32_t id, const Target& target) const;
  void add_track_lives(TrackQualityResult& result) const;

  TrackQualityParams params_;
  AssignmentSolver solver_;
  std::vector<const core::TargetTruth*> truth_;
  std::vector<const core::Track*> tracks_;
  std::vector<TrackOnTarget> pairs_;
  std::map<std::int32_t, Target> targets_;
  std::map<std::int64_t, TrackLife> lives_;
  std::int64_t first_utime_ = 0, last_utime_ = 0;
  int scans_ = 0, scans_with_right_count_ = 0;
  std::int64_t track_scans_ = 0;
};

}  // namespace lookout::tracking
