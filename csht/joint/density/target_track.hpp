#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csht/joint/density/trajectory_cloud.hpp"

namespace lookout::csht {

/// What the latest scans said of a track, one by one: the evidence that came and what was to be expected.
class RecentEvidence {
 public:
  static constexpr int kCapacity = 64;

  void clear() { size_ = 0; }
  void add(double evidence, double expected);
  int size() const { return size_; }
  double sum(int scans) const;       ///< Of the latest scans, scans <= size().
  double expected(int scans) const;  ///< Of the same.

 private:
  std::array<double, kCapacity> evidence_{}, expected_{};
  int next_ = 0;
  int size_ = 0;
};

/// One target that may exist: a density over its trajectory and the odds that it is there.
struct TargetTrack {
  bool used = false;  ///< The slot holds a track.
  std::int64_t id = 0;
  TrajectoryCloud cloud;
  CloudMoments moments;           ///< Of the cloud.
  double log_odds = 0.0;          ///< Of existence.
  double log_density = 0.0;       ///< ln of the prior density it was born with.
  double highest_log_odds = 0.0;  ///< Of its life.
  RecentEvidence recent;
  double visible_share = 1.0;   ///< Probability that it is in the field of view, if it exists.
  double echo_share = 0.0;      ///< Probability that the newest scan holds an echo of it, if it exists.
  double own_detections = 0.0;  ///< Expected number of detections that are its own, when last it claimed.
  std::int64_t first_scan = 0;  ///< Number of the scan since which its likelihood counts.
  bool remembers_birth = true;  ///< That scan is its first; not so after a manoeuvre.
  std::int64_t first_utime = 0;
  std::int64_t last_detection_utime = 0;
  std::int64_t in_view_utime = 0;  ///< Of the newest scan that had it in view.
  bool out_of_view = false;
  bool coasting = false;  ///< Out of view, but not for longer than the coast.
  bool reported = false;  ///< Part of the newest report.
  bool confirmed_once = false;
  bool has_claims = false;        ///< On scans before the newest.
  bool claims_are_fresh = false;  ///< They are those of the present cloud.
  std::vector<double> log_ratio;  ///< Of the newest scan, trajectory by trajectory.

  double existence() const;
  void advance(double seconds);  ///< Moves its trajectories on.

  /// How a track begins, but for its identity and its cloud.
  struct Beginning {
    double log_odds = 0.0;
    double log_density = 0.0;
    std::int64_t first_scan = 0;
    std::int64_t first_utime = 0;
    std::int64_t utime = 0;  ///< Of the newest scan.
  };
  void begin(const Beginning& beginning);  ///< Uses the slot for a new track with the cloud that it holds.
};

/// Probability of log odds, and back.
double probability(double log_odds);
double log_odds(double probability);

}  // namespace lookout::csht
