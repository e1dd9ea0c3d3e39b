#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "csht/joint/clusters.hpp"
#include "csht/joint/sampled_evidence.hpp"
#include "csht/joint/seeds.hpp"

namespace lookout::csht {

struct JointSearchParams {
  JointSeedParams seeds;
  JointClusterParams clusters;
  JointEvidenceParams evidence;
  TrajectoryPriorParams prior;
  int pool = 32;              ///< Candidates remembered from scan to scan, >= 1.
  double accept_above = 0.0;  ///< Log odds of existence from which a candidate is a target [nats].
  double cluster_above =
      -7.0;  ///< Log odds of a seed's best suffix from which it is worth clustering [nats].
  double evaluate_above = -9.0;      ///< Laplace log odds from which a candidate is worth sampling [nats].
  double sample_again_above = -4.0;  ///< The same of one sampled before, for what its score gained since.
  double second_look = 3.0;  ///< Candidates that fail by less have the verdict's many samples, >= 0 [nats].
};

/// The targets that a window of scans holds beside those already known: seeds, clusters, evidence, and a
/// choice in which each accepted target takes its beams from the rest. A tracker's birth method as well as
/// the heart of the `joint` estimator. Remembers candidates between scans; keeps its buffers.
class JointSearch {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  explicit JointSearch(const JointSearchParams& params);

  /// Call once for every scan pushed to `history`.
  /// @param window_scans scans to look back over, of those that history holds.
  /// @param known what targets outside this search own; they are not found again.
  /// @return the targets found, at the newest scan; valid until the next call.
  std::span<const TargetHypothesis> update(const ScanHistory& history, int window_scans,
                                           const ClaimSet& known, core::Random& random);

  /// Replaces the prior's number of targets in the field of view, > 0, as it is learnt.
  void set_targets_per_view(double targets_per_view);

  void clear();  ///< Forgets all candidates.

  std::span<const Seed> seeds() const { return seeds_found_; }  ///< Of the last update.
  std::span<const TargetHypothesis> candidates() const {
    return candidates_;
  }  ///< Not accepted, last update.
  std::span<const TargetHypothesis> targets() const {
    return targets_;
  }  ///< Of the last update, those that have left the field too.
  const TrajectoryPrior& prior() const { return prior_; }

 private:
  void move_to_newest(const ScanHistory& history);
  void claim_for_targets(const ScanHistory& history);
  void add_seeds(const ScanHistory& history, int window);
  void weigh_candidates(const ScanHistory& history, int window, core::Random& random);
  bool nearly_accepted(double log_odds) const;
  void choose(const ScanHistory& history, int window, core::Random& random);
  void estimate_again(const ScanHistory& history, int window, const ClaimSet& known, core::Random& random);
  void decide_given_others(const ScanHistory& history, int window, const ClaimSet& others, std::size_t first,
                           std::size_t end, std::size_t depth, core::Random& random);
  void forget_worst();
  std::span<const TargetHypothesis> those_in_view(const ScanTable& newest);

  JointSearchParams params_;
  TrajectoryPrior prior_;
  JointSeeds seeds_;
  JointClusters clusters_;
  JointEvidence evidence_;
  std::span<const Seed> seeds_found_;
  std::vector<TargetHypothesis> candidates_, fresh_, targets_;
  ClaimSet claims_;
  std::deque<ClaimSet> others_;  ///< One a depth of `decide_given_others`; references stay valid as it grows.
  std::int64_t utime_ = 0;
};

}  // namespace lookout::csht
