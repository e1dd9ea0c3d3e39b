#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csht/joint/density/trajectory_cloud.hpp"

namespace lookout::csht {

/// What each of the latest scans brought for a track: the evidence that came, and what was to be expected.
class RecentEvidence {
 public:
  static constexpr int kCapacity = 64;  ///< Scans that are kept.

  void clear() { size_ = 0; }  ///< Forgets all scans.
  /// Notes the evidence of the newest scan and what was to be expected of it, both [nats].
  void add(double evidence, double expected);
  int size() const { return size_; }  ///< Scans that it holds, at most kCapacity.
  double sum(int scans) const;        ///< Evidence of the latest scans [nats], scans <= size().
  double expected(int scans) const;   ///< What was expected of the same [nats].

 private:
  std::array<double, kCapacity> evidence_{}, expected_{};
  int next_ = 0;
  int size_ = 0;
};

/// One target that may exist: a density over its trajectory and the odds that it is there. A Bernoulli
/// component ([Ristic2013]) whose density is a cloud of weighted trajectories.
struct TargetTrack {
  bool used = false;              ///< The slot holds a track.
  std::int64_t id = 0;            ///< Its identity, > 0 and never used again.
  TrajectoryCloud cloud;          ///< The density of its trajectory, if it exists.
  CloudMoments moments;           ///< Of the cloud.
  double log_odds = 0.0;          ///< Of existence [nats].
  double log_density = 0.0;       ///< ln of the prior density that it began with [1 / (m^2 (m/s)^2)].
  double highest_log_odds = 0.0;  ///< Highest odds of its life so far [nats].
  RecentEvidence recent;          ///< Of its present motion.
  double visible_share = 1.0;     ///< Probability that it is in the field of view, if it exists.
  double detected_share = 0.0;    ///< Probability that the newest scan holds a detection of it, if it exists.
  /// Mean number of detections in memory that are its own, as of its last claims.
  double own_detections = 0.0;
  std::int64_t first_scan = 0;  ///< Number of the scan since which its likelihood counts.
  /// Its likelihood counts from its first scan on; false after a change of motion.
  bool remembers_birth = true;
  std::int64_t first_utime = 0;           ///< Of its first scan [us].
  std::int64_t last_detection_utime = 0;  ///< Of the newest scan with a detection of its own [us].
  std::int64_t in_view_utime = 0;         ///< Of the newest scan that had it in view [us].
  bool out_of_view = false;               ///< At the newest scan.
  bool coasting = false;                  ///< Out of view, but not for longer than the coast.
  bool reported = false;                  ///< Part of the newest report.
  bool confirmed_once = false;            ///< It was part of a report.
  bool has_claims = false;                ///< On scans before the newest.
  bool claims_are_fresh = false;          ///< They were made with the present cloud.
  std::vector<double> log_ratio;  ///< Log-likelihood ratio of the newest scan for each trajectory [nats].

  double existence() const;      ///< Probability of it, from `log_odds`.
  void advance(double seconds);  ///< Moves its trajectories on by so much time [s].

  /// How a track begins, but for its identity and its cloud.
  struct Beginning {
    double log_odds = 0.0;         ///< Of existence [nats].
    double log_density = 0.0;      ///< See TargetTrack.
    std::int64_t first_scan = 0;   ///< See TargetTrack.
    std::int64_t first_utime = 0;  ///< Of that scan [us].
    std::int64_t utime = 0;        ///< Of the newest scan [us].
  };
  void begin(const Beginning& beginning);  ///< Uses the slot for a new track with the cloud that it holds.
};

/// The probability that has these log odds [nats].
double probability(double log_odds);
/// ln(p / (1 - p)) of a probability in (0, 1) [nats].
double log_odds(double probability);

}  // namespace lookout::csht
