#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "tracking/joint_birth.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_report.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// The tracker at the physical limit of the sonar: each target is a density over its trajectories under the
/// exact likelihood of the last minute of scans, with odds of existence; births come from pairs of echoes
/// that no track explains; what is reported minimises the expected OSPA. docs/tracker.md.
class JointTracker : public Tracker {
 public:
  /// @param sonar its probabilities, where given, are taken as known.
  /// @param seed of all draws; those of a scan derive from (seed, scan sequence) alone.
  /// @throws std::invalid_argument on a parameter out of range.
  JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  std::span<const core::Track> update(const core::PosedScan& scan) override;

 private:
  void take(const core::PosedScan& scan);
  void claim_provisionally();
  void update_tracks();
  void update_track(std::size_t slot);
  void refresh(std::size_t slot);
  void observe(std::size_t slot, int age, bool claim, std::size_t stride);
  void observe_point(std::size_t slot, int age);
  void fill_past_claims(std::size_t slot);
  void end_twins();
  void begin_tracks();
  bool begin_track(const BirthSeed& seed);
  bool known(const BirthSeed& seed);
  std::size_t free_slot();
  void end_lives();
  bool life_over(const JointTrack& track) const;
  void end(std::size_t slot);
  void choose_report();
  double unseen_targets();
  void publish();
  AgeSpan memory_of(const JointTrack& track) const;

  JointTrackerParams params_;
  core::SonarParams sonar_;
  std::uint64_t seed_;
  core::Random random_;
  JointLikelihood likelihood_;
  JointBirth birth_;
  JointSampler sampler_;
  JointReport report_;
  std::vector<JointTrack> tracks_;  ///< Slots.
  JointCloud fresh_;                ///< Where a cloud is drawn before it replaces another.
  std::vector<double> beam_share_, beam_range_, detection_ratio_;
  std::vector<int> beams_touched_;
  std::vector<ReportCandidate> candidates_;
  std::vector<core::Track> published_;
  double unseen_ = 0.0;
  std::int64_t last_id_ = 0;
};

}  // namespace lookout::tracking
