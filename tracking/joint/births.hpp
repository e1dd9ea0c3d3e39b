#pragma once

#include <memory>
#include <vector>

#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "csht/joint/evidence/beam_claims.hpp"
#include "csht/joint/evidence/memory_span.hpp"
#include "csht/joint/pair_seeds.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Begins tracks: on the seeds of its own pairs of echoes, or on what a birth method proposes, where the
/// evidence for a seed is worth a tentative track.
class Births {
 public:
  /// @param params validated. @param births null: pairs of echoes.
  Births(const JointTrackerParams& params, const csht::TargetPrior& prior,
         std::unique_ptr<BirthMethod> births);

  /// Begins tracks at the newest scan, which is `scan`.
  void begin(const core::PosedScan& scan, TrackerState& state);

 private:
  void begin_on_pairs(TrackerState& state);
  void begin_on_proposals(const core::PosedScan& scan, TrackerState& state);
  bool known(const csht::BirthSeed& seed, TrackerState& state) const;
  bool draw(const csht::BirthSeed& seed, double& log_odds, TrackerState& state) const;
  void begin_track(const csht::BirthSeed& seed, TrackerState& state);

  csht::BirthParams params_;
  LifeParams life_;
  csht::TrajectoryCloudParams cloud_;
  csht::MemorySpan memory_;
  csht::TargetPrior prior_;
  double log_density_ = 0.0;  ///< ln of the prior density of targets at the newest scan.
  csht::AgeSpan window_;      ///< Scans that a seed is weighed over.
  csht::PairSeeds birth_;
  std::unique_ptr<BirthMethod> births_;
  std::vector<core::Track> living_;  ///< What `births_` is told of the tracks.
  csht::BeamClaims observer_;
};

}  // namespace lookout::tracking
