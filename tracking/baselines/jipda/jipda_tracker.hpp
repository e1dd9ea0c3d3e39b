#pragma once

#include <vector>

#include "tracking/baselines/gaussian/bernoulli_decisions.hpp"
#include "tracking/baselines/gaussian/bernoulli_track.hpp"
#include "tracking/baselines/gaussian/switching_motion.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// Parameters of JipdaTracker. How they were chosen: docs/rivals.md.
struct JipdaParams {
  SwitchingMotionParams motion;  ///< See there.
  ScanViewParams view;           ///< See there.
  PopulationParams population;   ///< See there.
  ExistenceParams existence;     ///< See there.
  /// Joint events of a cluster that are summed one by one, >= 1; a cluster of more is solved by belief
  /// propagation.
  double most_events = 3000.0;
  /// Squared Mahalanobis distance of two tracks' states below which the less probable one is dropped, >= 0.
  double twin_distance = 3.0;

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Joint integrated probabilistic data association: each track knows its probability of existence, which
/// follows a Markov chain, and takes in all returns by the probability that they are its own. [Musicki2004]
class JipdaTracker : public Tracker {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  JipdaTracker(const JipdaParams& params, const core::SonarParams& sonar);

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
  void drop_twins();
  void step_lives();
  void learn();
  void begin();
  std::span<const core::Track> report();

  JipdaParams params_;
  SwitchingMotion motion_;
  RivalScene scene_;
  BernoulliDecisions decisions_;
  std::vector<BernoulliTrack> tracks_;
  BernoulliUpdate update_;
  std::vector<double> free_;
  std::vector<core::Track> reported_;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
