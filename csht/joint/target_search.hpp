#pragma once

#include <span>
#include <vector>

#include "core/motion_element.hpp"
#include "csht/joint/evidence/beam_claims.hpp"
#include "csht/joint/evidence/memory_span.hpp"
#include "csht/joint/joint_scene.hpp"
#include "csht/joint/pair_seeds.hpp"

namespace lookout::csht {

/// Finds targets that a scene has no hypothesis for: pairs of detections that none explains give seeds, and
/// importance sampling gives the evidence for each ([Cappe2004] Sec. 2), less what the hypotheses before it
/// have claimed. Seeds that are probable enough become hypotheses of the scene. docs/joint_estimator.md.
class TargetSearch {
 public:
  /// @param params validated.
  explicit TargetSearch(const JointEngineParams& params);

  /// Looks for new targets at the newest scan. @return the slots of those found; valid until the next call.
  std::span<const int> find(JointScene& scene);

  /// Weighs seeds of another method as it does its own. @return the slots of those kept; valid until the next
  /// call.
  std::span<const int> weigh(std::span<const BirthSeed> seeds, JointScene& scene);

  /// Takes the newest scan into the weights and the odds of a hypothesis, given the claims of all others.
  /// @return whether enough of its trajectories still count; else it should be revised.
  bool update(TargetTrack& track, JointScene& scene) const;

  /// Draws the density of a hypothesis anew from the whole window, given the claims of all others, and with
  /// it its odds and claims. Where no trajectory fits, its odds become very low.
  void revise(TargetTrack& track, JointScene& scene);

 private:
  void prepare(const JointScene& scene);
  int window_of(const CloudMoments& moments, const ScanHistory& scans) const;
  bool known(const BirthSeed& seed, JointScene& scene) const;
  bool draw(const BirthSeed& seed, double& log_odds, JointScene& scene) const;
  void begin(const BirthSeed& seed, JointScene& scene);
  void claim(TargetTrack& track, JointScene& scene);

  BirthParams params_;
  HypothesisParams hypotheses_;
  TrajectoryCloudParams cloud_;
  double log_density_ = 0.0;  ///< ln of the prior density of targets at the newest scan.
  PairSeeds seeds_;
  BeamClaims claims_;
  std::vector<int> found_;
};

/// An element of another method as a seed: its state, its covariance and since when it is there.
BirthSeed seed_of(const core::MotionElement& element, const ScanHistory& scans);

}  // namespace lookout::csht
