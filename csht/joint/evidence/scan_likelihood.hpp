#pragma once

#include <span>
#include <vector>

#include "core/sonar_scan.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/joint/density/trajectory_cloud.hpp"
#include "csht/likelihood/beam_mask.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// What one track takes of one scan: a beam that it is in (with its range there), or a detection of a point
/// sensor.
struct Claim {
  int owner = 0;       ///< Slot of the track.
  int index = 0;       ///< Beam, or index of the detection.
  float range = 0.0F;  ///< Of the track in that beam [m].
  float share = 0.0F;  ///< Probability, were the track real.
};

/// Ages of scans, both included; 0 is the newest.
struct AgeSpan {
  int newest = 0;
  int oldest = 0;
  /// A trajectory may begin at any scan of the span; else it is there from the oldest on.
  bool births = false;
};

/// The likelihood of trajectories over the latest scans, with what other tracks explain left out: in a beam
/// shared with a nearer target, the farther one learns nothing. docs/joint_estimator.md.
class ScanLikelihood {
 public:
  static constexpr int kNobody = -1;     ///< As `self`: the claims of all tracks count.
  static constexpr int kEverybody = -2;  ///< As `self`: no claims count.

  /// @param capacity scans kept, >= 1.
  /// @param max_owners slots that may claim.
  ScanLikelihood(const SensorFigures& figures, const SensorModelParams& model, const Tolerance& tolerance,
                 int capacity, int max_owners, const TargetPrior& prior = TargetPrior());

  /// @param unseen targets that may stand anywhere in view before this scan, with no track, relative to those
  /// of the prior.
  void push(const core::PosedScan& scan, double unseen = 1.0);
  const ScanHistory& scans() const { return scans_; }
  /// ln of the targets that appear at the scan of this age, relative to those that stand there.
  double log_birth(int age) const {
    return prior_.log_birth(core::seconds(scans_.at_age(age).utime - first_utime_));
  }
  void set_prior(const TargetPrior& prior) { prior_ = prior; }
  void set_figures(const SensorFigures& figures) { scans_.set_figures(figures); }
  void set_heading_error(int age, const HeadingError& error) { scans_.set_heading_error(age, error); }

  /// How sure the owner of a slot is to exist; its claims count by that much. Below `kLeastExistence` they
  /// do not count.
  void set_existence(int owner, double existence);
  static constexpr double kLeastExistence = 0.1;

  void add_claim(int age, const Claim& claim);
  void forget_claims(int owner);
  void forget_claims(int owner, int age);

  /// Sets `log_ratio[i]` to ln of the density of targets that stood where hypothesis i, moved by `seconds`,
  /// was before the scan of age `oldest`, relative to that of the prior: in view, as far as they were not
  /// found yet.
  void begin(const HypothesisSpan& hypotheses, double seconds, int oldest, std::span<double> log_ratio);

  /// Adds to `log_ratio[i]` what the scans of these ages say of trajectory i, the claims of all but `self`
  /// left out; with births, what `log_ratio` held before is lost. The sum over the beginnings is
  /// Q_t = (Q_{t-1} + birth) L_t, oldest first, as in docs/joint_estimator.md.
  /// @param mean of the trajectories, near which claims matter.
  void add(const TrajectoryCloud& cloud, const Trajectory& mean, const AgeSpan& ages, int self,
           std::span<double> log_ratio);

  /// The claims of all but `self` on the scan of this age as a mask; null where nothing is claimed. Valid
  /// until the next call. @param beam only claims within `kNeighbourhood` beams of it; negative: all.
  const BeamMask* mask(int age, int self, int beam);
  static constexpr int kNeighbourhood = 10;

  /// Whether what the others claim of the newest scan may be an echo of a target at `mean`; taken for granted
  /// of beams that others claim near it.
  bool contested(int self, const Trajectory& mean);

  /// Probability that a track made an echo of that scan, judged by the claims on its beam and both neighbours
  /// and by its range. @param index beam, or index of the detection of a point sensor.
  double explained(int age, int index, double range) const;

 private:
  std::vector<Claim>& claims_at(int age);
  const std::vector<Claim>& claims_at(int age) const;
  std::size_t ring_index(int age) const;
  void claim_beam(const ScanTable& scan, const Claim& claim, double share);
  void begin_cloud(const TrajectoryCloud& cloud, int oldest, std::span<double> log_ratio);
  void add_scan(const TrajectoryCloud& cloud, int age, const BeamMask* mask, std::span<double> log_ratio);

  Tolerance tolerance_;
  ScanHistory scans_;
  TargetPrior prior_;
  std::int64_t first_utime_ = 0;
  std::vector<double> log_unseen_;  ///< As given to `push`, of each scan kept.
  std::vector<std::vector<Claim>> claims_;
  std::vector<double> existence_;
  BeamMask mask_;
  TrajectoryCloud moved_;
  std::vector<float> range_, bearing_;  ///< Of hypotheses, where they begin.
};

/// The beam in which the scan has an earth-frame position; out of 0 .. num_beams - 1 outside the sector.
int beam_at(const ScanTable& scan, double north, double east);

}  // namespace lookout::csht
