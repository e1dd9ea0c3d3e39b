#pragma once

#include <span>
#include <vector>

#include "core/motion_element.hpp"
#include "csht/joint/evidence/beam_claims.hpp"
#include "csht/joint/evidence/memory_span.hpp"
#include "csht/joint/joint_scene.hpp"
#include "csht/joint/pair_seeds.hpp"

namespace lookout::csht {

/// Finds targets beyond those that a scene holds: seeds from pairs of detections that no hypothesis explains,
/// then the evidence for each by importance sampling, given what the hypotheses before it have claimed. What
/// is worth keeping becomes a hypothesis of the scene. docs/joint_estimator.md.
class TargetSearch {
 public:
  /// @param params validated.
  explicit TargetSearch(const JointEngineParams& params);

  /// Looks for new targets at the newest scan. @return the slots of those found; valid until the next call.
  std::span<const int> find(JointScene& scene);

  /// Weighs seeds from outside as its own. @return the slots of those kept; valid until the next call.
  std::span<const int> weigh(std::span<const BirthSeed> seeds, JointScene& scene);

  /// Takes the newest scan into a hypothesis, the claims of all others left out: weights and odds follow.
  /// @return whether enough of its trajectories still count; else it should be revised.
  bool update(TargetTrack& track, JointScene& scene) const;

  /// Draws the density and the odds of a hypothesis anew from the whole window, the claims of all others left
  /// out; its claims follow. The odds are those of nothing where no trajectory fits.
  void revise(TargetTrack& track, JointScene& scene);

 private:
  void prepare(const JointScene& scene);
  bool known(const BirthSeed& seed, JointScene& scene) const;
  bool draw(const BirthSeed& seed, double& log_odds, JointScene& scene) const;
  void begin(const BirthSeed& seed, JointScene& scene);
  void claim(TargetTrack& track, JointScene& scene);

  BirthParams params_;
  HypothesisParams hypotheses_;
  TrajectoryCloudParams cloud_;
  double log_density_ = 0.0;  ///< ln of the prior density of targets at the newest scan.
  AgeSpan window_;            ///< Scans that a seed is weighed over.
  PairSeeds seeds_;
  BeamClaims claims_;
  std::vector<int> found_;
};

/// An element of another method as a seed: its state, spread and age.
BirthSeed seed_of(const core::MotionElement& element, const ScanHistory& scans);

}  // namespace lookout::csht
