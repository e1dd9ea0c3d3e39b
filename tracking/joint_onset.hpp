#pragma once

#include <memory>
#include <vector>

#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "tracking/birth.hpp"
#include "tracking/joint_birth.hpp"
#include "tracking/joint_memory.hpp"
#include "tracking/joint_observer.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_state.hpp"

namespace lookout::tracking {

/// Begins tracks: on the seeds of its own pairs of echoes, or on what a birth method proposes, where the
/// evidence for a seed is worth a tentative track.
class JointOnset {
 public:
  /// @param params validated. @param births null: pairs of echoes.
  JointOnset(const JointTrackerParams& params, const JointPrior& prior, std::unique_ptr<BirthMethod> births);

  /// Begins tracks at the newest scan, which is `scan`.
  void begin(const core::PosedScan& scan, JointState& state);

 private:
  void begin_on_pairs(JointState& state);
  void begin_on_proposals(const core::PosedScan& scan, JointState& state);
  bool known(const BirthSeed& seed, JointState& state) const;
  bool draw(const BirthSeed& seed, double& log_odds, JointState& state) const;
  void begin_track(const BirthSeed& seed, JointState& state);

  JointBirthParams params_;
  JointLifeParams life_;
  JointCloudParams cloud_;
  JointMemory memory_;
  JointPrior prior_;
  double log_density_ = 0.0;  ///< ln of the prior density of targets at the newest scan.
  AgeSpan window_;            ///< Scans that a seed is weighed over.
  JointBirth birth_;
  std::unique_ptr<BirthMethod> births_;
  std::vector<core::Track> living_;  ///< What `births_` is told of the tracks.
  JointObserver observer_;
};

}  // namespace lookout::tracking
