#pragma once

#include <span>
#include <vector>

#include "tracking/baselines/gaussian/bernoulli_track.hpp"
#include "tracking/baselines/gaussian/switching_motion.hpp"
#include "tracking/baselines/gaussian/weighted_target.hpp"

namespace lookout::tracking {

/// A target that may exist, with the single-target hypotheses of what it has been: one a history of returns.
struct TrackTree {
  BernoulliTrack head;  ///< Identity, life, and the hypotheses summed up: existence, target, spread.
  /// Their weights are the probabilities that it exists and has this history; they sum to the existence.
  std::vector<WeightedTarget> hypotheses;
};

/// Sums up the hypotheses in `head`: existence and target.
void sum_up(TrackTree& tree);

/// Carries the hypotheses ahead; the target survives with this probability. Claims its returns in the view.
void predict(TrackTree& tree, const SwitchingMotion& motion, RivalScene& scene);

/// Takes a scan into trees that are independent of each other but for the returns that they share: the joint
/// association is summed to marginals, each history with each return is a history of its own. TOMB/P of
/// [Williams2015] with the mixture kept.
class TrackTreeUpdate {
 public:
  /// @param most_events see AssociationMarginals.
  TrackTreeUpdate(double most_events, const ReductionParams& reduction)
      : marginals_(most_events), reduction_(reduction) {}

  /// Weighs what every tree may have. @param trees predicted to the scan.
  void weigh(std::span<const TrackTree> trees, const RivalScene& scene);
  /// After `weigh`: expected odds that a return is one of these trees'.
  double odds(std::size_t detection) const { return odds_[detection]; }
  /// After `weigh`: the trees given the scan. @param free of each return: probability that nothing else owns
  /// it.
  void update(std::span<TrackTree> trees, const RivalScene& scene, std::span<const double> free);
  /// After `update`: probability that a return belongs to none of the trees.
  double unclaimed(std::size_t detection) const { return marginals_.unclaimed(static_cast<int>(detection)); }

 private:
  /// A hypothesis of a tree with one return.
  struct Branch {
    std::size_t hypothesis = 0;
    double weight = 0.0;  // Of the hypothesis and the return.
  };
  void weigh_returns(const TrackTree& tree, int index, const RivalScene& scene);
  void grow(std::size_t index, TrackTree& tree, const RivalScene& scene);

  AssociationMarginals marginals_;
  ReductionParams reduction_;
  std::vector<double> odds_;
  std::vector<double> missed_;           // Of each tree: weight of having no return.
  std::vector<double> hypothesis_miss_;  // Of the hypotheses of all trees: weight of having no return.
  std::vector<std::size_t> first_miss_, first_pair_;  // Of each tree, into the lists; one more at the end.
  std::vector<AssociationPair> pairs_, freed_;
  std::vector<std::size_t> first_branch_;  // Of each pair; one more at the end.
  std::vector<Branch> branches_;
};

}  // namespace lookout::tracking
