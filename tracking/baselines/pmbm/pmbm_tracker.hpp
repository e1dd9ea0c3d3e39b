#pragma once

#include <vector>

#include "tracking/baselines/gaussian/bernoulli_decisions.hpp"
#include "tracking/baselines/pmbm/hypothesis_mixture.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// Parameters of PmbmTracker. How they were chosen: docs/rivals.md.
struct PmbmParams {
  SwitchingMotionParams motion;  ///< See there.
  ScanViewParams view;           ///< See there.
  PopulationParams population;   ///< See there.
  ExistenceParams existence;     ///< See there.
  ReductionParams reduction;     ///< Of the single-target hypotheses of a track below `promote`.
  MixtureParams mixture;         ///< See there.
  /// Joint events of a cluster of such tracks that are summed one by one, >= 1; a cluster of more is solved
  /// by belief propagation.
  double most_events = 1000.0;
  double promote = 0.05;  ///< Existence from which a track enters the global hypotheses, in (0, 1).
  double demote = 0.01;   ///< Existence below which an unconfirmed one leaves them, > 0 and below `promote`.
  /// Squared Mahalanobis distance of two tracks' states below which the less probable one is dropped, >= 0.
  double twin_distance = 3.0;
  /// Report a track as the heaviest global hypothesis has it; else the mean over all.
  bool report_best = false;

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// The Poisson multi-Bernoulli mixture filter, track-oriented: undetected targets are a Poisson process,
/// every return may begin a track, a track has single-target hypotheses, and global hypotheses, found by
/// Murty's method, say which belong together. [Williams2015], [GarciaFernandez2018]
///
/// Tracks that hardly exist, one a false return, are held by their marginal probabilities (TOMB/P), so that
/// the global hypotheses are spent on targets.
class PmbmTracker : public Tracker {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  PmbmTracker(const PmbmParams& params, const core::SonarParams& sonar);

  /// Works on returns alone: `elements` are not used.
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { decisions_.tell_to(log); }
  std::int64_t next_id() const override { return next_id_; }
  void set_next_id(std::int64_t id) override { next_id_ = id; }

 private:
  void predict();
  void associate();
  void step_lives();
  void drop_twins();
  void learn();
  void move_between();
  void begin();
  std::span<const core::Track> report();
  void collect_heads();
  void drop(const std::vector<char>& dropped);

  PmbmParams params_;
  SwitchingMotion motion_;
  RivalScene scene_;
  BernoulliDecisions decisions_;
  HypothesisMixture mixture_;     ///< Of the tracks that exist probably.
  std::vector<TrackTree> trees_;  ///< The others.
  TrackTreeUpdate update_;
  std::vector<double> free_;
  std::vector<BernoulliTrack> heads_;  ///< Of all tracks, those of the mixture first.
  std::vector<core::Track> reported_;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
