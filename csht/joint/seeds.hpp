#pragma once

#include <span>
#include <vector>

#include "csht/likelihood/claim_set.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

/// A trajectory through two echoes, at the time of the newest scan.
struct Seed {
  Eigen::Vector4d state{0, 0, 0, 0};  ///< North, east [m], north velocity, east velocity [m/s].
  int gap = 0;                        ///< Scans between its two echoes.
  double score = 0.0;                 ///< Log-likelihood ratio of its best suffix of scans [nats].
};

/// Covariance of a seed, from the errors of its two echoes.
Eigen::Matrix4d covariance_of(const Seed& seed, const ScanHistory& history);

/// The sparse Hough transform in four dimensions: a pair of echoes is an exact vote.
struct JointSeedParams {
  int min_gap = 3;   ///< Least scans between the two echoes, >= 1: nearer ones say little of velocity.
  int max_gap = 20;  ///< Most scans between them, >= min_gap.
  double speed_slack = 1.0;       ///< Sigmas of the pair's own velocity error beyond the speed limit, >= 0.
  Tolerance tolerance{1.4, 0.5};  ///< Two echoes' errors on top of the third's.
  int first_drop = 4;             ///< Scans scored before the first seeds are dropped, >= 1.
  double drop_below = -4.0;       ///< A seed whose best suffix so far is below is dropped [nats].
  double drop_fall =
      14.0;  ///< A seed that fell so far below its best suffix is scored no further [nats], > 0.
  double ended_above = 6.0;  ///< ... and stays a candidate where that suffix is above [nats].
  int keep = 32;             ///< Best distinct seeds that are kept, >= 1.
  double distinct = 1.0;     ///< Seeds nearer than this many (sigma, and sigma over 2 s) are one, > 0.
  int max_pairs = 40000;     ///< Bound on the pairs of a scan, >= 1: those of the longest gaps are left out.
};

/// Finds the seeds through the newest scan's echoes. Keeps its buffers.
class JointSeeds {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  JointSeeds(const JointSeedParams& params, double max_speed);

  /// The best distinct seeds through an echo of the newest scan and an older one, neither claimed, scored
  /// backwards over at most `window_scans` scans. Best first; valid until the next call.
  std::span<const Seed> find(const ScanHistory& history, int window_scans, const ClaimSet& claims);

  std::size_t last_pairs() const { return num_scored_; }  ///< Pairs scored by the last `find`.

 private:
  void pair_up(const ScanHistory& history, int window_scans, const ClaimSet& claims);
  void score_backwards(const ScanHistory& history, int window_scans, const ClaimSet& claims);
  void drop_hopeless();
  Seed seed_at(std::size_t index) const;
  void keep_best(double sigma);

  JointSeedParams params_;
  double max_speed_;
  std::vector<double> north_, east_, north_velocity_, east_velocity_, sum_, best_;
  std::vector<int> gap_;
  std::size_t num_pairs_ = 0, num_scored_ = 0;
  std::vector<Seed> ended_;  ///< Scored no further, with a good suffix: targets that came within the window.
  std::vector<Seed> kept_;
};

}  // namespace lookout::csht
