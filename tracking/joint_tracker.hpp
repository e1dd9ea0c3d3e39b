#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "csht/sensor_figures.hpp"
#include "tracking/birth.hpp"
#include "tracking/joint_birth.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_manoeuvre.hpp"
#include "tracking/joint_observer.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_report.hpp"
#include "tracking/joint_retrodiction.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"
#include "tracking/joint_unseen.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// The tracker at the physical limit of the sonar: each target is a density
/// over its trajectories under the exact likelihood of the last minute of
/// scans, with odds of existence; births come from pairs of echoes that no
/// track explains; what is reported minimises the expected OSPA.
/// docs/tracker.md.
class JointTracker : public Tracker {
 public:
  /// @param sonar its figures, where given, are used until the scans contradict
  /// them; else they are estimated.
  /// @param seed of all draws; those of a scan derive from (seed, scan
  /// sequence) alone.
  /// @param births where tracks begin in place of its own pairs of echoes; null: those.
  /// @throws std::invalid_argument on a parameter out of range.
  JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed,
               std::unique_ptr<BirthMethod> births = nullptr);

  std::span<const core::Track> update(const core::PosedScan& scan) override;
  std::optional<core::SensorEstimate> sensor_estimate() const override { return figures_.estimate(); }
  void explain_to(DecisionLog log) override { log_ = std::move(log); }
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override;

 private:
  void take(const core::PosedScan& scan);
  void claim_provisionally();
  void update_tracks();
  void update_track(std::size_t slot);
  void refresh(std::size_t slot);
  void judge_motion(std::size_t slot);
  void claim(std::size_t slot);
  void end_twins();
  void begin_tracks();
  void begin_on_proposals(const core::PosedScan& scan);
  void begin_track(const BirthSeed& seed);
  bool known(const BirthSeed& seed);
  bool draw_birth(const BirthSeed& seed, double& log_odds);
  std::size_t free_slot();
  void end_lives();
  const char* reason_to_end(const JointTrack& track) const;
  void end(std::size_t slot, DecisionKind kind, const char* reason);
  void choose_report();
  void learn_sensor();
  void publish();
  void publish_track(const JointTrack& track);
  AgeSpan memory_of(const JointTrack& track) const;
  std::int64_t now() const { return likelihood_.scans().newest().utime; }
  void decide(const JointTrack& track, DecisionKind kind, double evidence, const char* reason) const;

  JointTrackerParams params_;
  double max_speed_;
  std::uint64_t seed_;
  core::Random random_;
  JointLikelihood likelihood_;
  JointSampler sampler_;
  JointObserver observer_;
  JointManoeuvre manoeuvre_;
  JointBirth birth_;
  std::unique_ptr<BirthMethod> births_;
  std::vector<core::Track> living_;  ///< What `births_` is told of the tracks.
  JointUnseen unseen_;
  JointReport report_;
  JointRetrodiction retrodiction_;
  csht::SensorFigureEstimator figures_;
  std::vector<std::vector<Eigen::Vector4d>> target_samples_;
  std::vector<csht::KnownTarget> targets_;
  std::vector<JointTrack> tracks_;  ///< Slots, used again when free.
  JointCloud fresh_;                ///< Where a cloud is drawn before it replaces another.
  double unseen_targets_ = 0.0;
  std::vector<ReportCandidate> candidates_;
  std::vector<core::Track> published_;
  std::int64_t last_id_ = 0;
  DecisionLog log_;
};

}  // namespace lookout::tracking
