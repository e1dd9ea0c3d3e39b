#pragma once

#include <span>
#include <vector>

#include "core/sonar_scan.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/joint/density/trajectory_cloud.hpp"
#include "csht/joint/density/wander.hpp"
#include "csht/likelihood/beam_mask.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// What one track takes of one scan: a beam that it is in, with its range there, or, of a sensor without
/// beams, a detection.
struct Claim {
  int owner = 0;       ///< Slot of the track.
  int index = 0;       ///< Beam, or index of the detection.
  float range = 0.0F;  ///< Of the track in that beam [m].
  float share = 0.0F;  ///< Probability that it is in the beam (made the detection), if it exists.
};

/// Ages of scans, both included; 0 is the newest.
struct AgeSpan {
  int newest = 0;  ///< Smallest age.
  int oldest = 0;  ///< Largest age.
  /// Whether a target may appear at any scan of the span; else it is there from the oldest on.
  bool births = false;
};

/// The likelihood of trajectories over the latest scans, given what other tracks claim of them: a beam that
/// a nearer target owns says nothing of a farther one. docs/joint_estimator.md.
class ScanLikelihood {
 public:
  static constexpr int kNobody = -1;     ///< As `self`: the claims of all tracks count.
  static constexpr int kEverybody = -2;  ///< As `self`: no claims count.

  /// @param figures validated, like `model` and `tolerance`.
  /// @param capacity scans kept, >= 1. @param max_owners slots that may claim.
  ScanLikelihood(const SensorFigures& figures, const SensorModelParams& model, const Tolerance& tolerance,
                 int capacity, int max_owners, const TargetPrior& prior = TargetPrior());

  /// Takes the next scan, later than all before it. @param undetected density of targets without a track that
  /// may be anywhere in view before this scan, over that of the prior, in [0, 1].
  void push(const core::PosedScan& scan, double undetected = 1.0, int sensor = 0);
  const ScanHistory& scans() const { return scans_; }  ///< Those that are kept, with their figures.
  /// ln of the number of targets that appear at the scan of this age, over that of those in view already.
  double log_birth(int age) const {
    return prior_.log_birth(core::seconds(scans_.at_age(age).utime - first_utime_));
  }
  void set_wander(const Wander& wander) { wander_ = wander; }   ///< Holds from the next call on.
  void set_prior(const TargetPrior& prior) { prior_ = prior; }  ///< Holds from the next call on.
  /// Rewrites P_F, P_M and sigma in every scan that is kept.
  void set_figures(const SensorFigures& figures) { scans_.set_figures(figures); }
  /// Groups the returns of the scan of this age that one echo may have made.
  void group(int age, const SpillModel& spill, std::span<const float> background) {
    scans_.group(age, spill, background);
  }
  /// Sets the background's share of each return of the scan of this age, see ScanHistory.
  void set_background(int age, std::span<const float> background) { scans_.set_background(age, background); }
  /// Sets what the intensity of each return of the scan of this age tells, see ScanHistory.
  void set_loudness(int age, std::span<const float> loudness) { scans_.set_loudness(age, loudness); }
  /// Turns the scan of this age to the heading that is now believed.
  void set_heading_error(int age, const HeadingError& error) { scans_.set_heading_error(age, error); }

  /// Sets the probability that the owner of a slot exists: its claims count by it, and not at all below
  /// `kLeastExistence`.
  void set_existence(int owner, double existence);
  static constexpr double kLeastExistence = 0.1;  ///< Least existence of a track whose claims count.

  void add_claim(int age, const Claim& claim);  ///< On the scan of this age.
  void forget_claims(int owner);                ///< Those of a slot on all scans.
  void forget_claims(int owner, int age);       ///< Those of a slot on the scan of this age.

  /// Sets `log_ratio[i]` to ln of the density of undetected targets, over that of the prior, where hypothesis
  /// i, moved by `seconds`, was just before the scan of age `oldest`: in view as given to `push` with that
  /// scan, out of view 1.
  void begin(const HypothesisSpan& hypotheses, double seconds, int oldest, std::span<double> log_ratio);

  /// Adds to `log_ratio[i]` ln of the likelihood ratio of trajectory i over the scans of these ages, given
  /// the claims of all tracks but `self`. With births it is the sum over the scans at which the target may
  /// have appeared, Q_t = (Q_{t-1} + birth) L_t, oldest first ([Granstrom2018] has such densities over
  /// trajectories), and replaces what `log_ratio` held. docs/joint_estimator.md.
  /// @param mean of the trajectories, near which claims matter.
  void add(const TrajectoryCloud& cloud, const Trajectory& mean, const AgeSpan& ages, int self,
           std::span<double> log_ratio);

  /// By how much a target at `mean` may miss a return of the scan of this age; see Wander.
  Tolerance tolerance_at(int age, const Trajectory& mean) const;

  /// The claims of all but `self` on the scan of this age as a mask; null where nothing is claimed. Valid
  /// until the next call. @param beam only claims within `kNeighbourhood` beams of it; negative: all.
  const BeamMask* mask(int age, int self, int beam);
  static constexpr int kNeighbourhood = 10;  ///< [beams].

  /// Whether others claim what may be the detection of a target at `mean`: of a sensor without beams, one
  /// that is near it; of beams, any within `kNeighbourhood`.
  bool contested(int self, const Trajectory& mean);

  /// Probability that a known track made the return at `range` [m] of the scan of this age: the claims on its
  /// beam and on both neighbours whose range fits. @param index beam, or index of a point sensor's detection.
  /// @param owners if given, holds 0 for each slot whose claims do not count.
  double explained(int age, int index, double range, std::span<const char> owners = {}) const;

 private:
  std::vector<Claim>& claims_at(int age);
  const std::vector<Claim>& claims_at(int age) const;
  std::size_t ring_index(int age) const;
  void claim_beam(const ScanTable& scan, const Claim& claim, double share);
  void claim_group(const ScanTable& scan, const Claim& claim, double share);
  void begin_cloud(const TrajectoryCloud& cloud, int oldest, std::span<double> log_ratio);
  void add_scan(const TrajectoryCloud& cloud, int age, const BeamMask* mask, const Tolerance& tolerance,
                std::span<double> log_ratio);

  Tolerance tolerance_;
  Wander wander_;
  ScanHistory scans_;
  TargetPrior prior_;
  std::int64_t first_utime_ = 0;
  std::vector<double> log_undetected_;  ///< As given to `push`, of each scan kept.
  std::vector<std::vector<Claim>> claims_;
  std::vector<double> existence_;
  BeamMask mask_;
  TrajectoryCloud moved_;
  std::vector<float> range_, bearing_;  ///< Of hypotheses, where they begin.
};

/// The beam in which the scan has a position [m, earth frame]; outside 0 .. num_beams - 1 if none has.
int beam_at(const ScanTable& scan, double north, double east);

}  // namespace lookout::csht
