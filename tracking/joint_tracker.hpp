#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "tracking/birth.hpp"
#include "tracking/joint_ending.hpp"
#include "tracking/joint_filter.hpp"
#include "tracking/joint_heading.hpp"
#include "tracking/joint_learning.hpp"
#include "tracking/joint_onset.hpp"
#include "tracking/joint_output.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_state.hpp"
#include "tracking/joint_unseen.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// The tracker at the physical limit of the sonar: each target is a density over its trajectories under the
/// exact likelihood of the last minute of scans, with odds of existence; births come from pairs of echoes
/// that no track explains; what is reported minimises the expected OSPA. docs/tracker.md.
class JointTracker : public Tracker {
 public:
  /// @param sonar its figures, where given, are used until the scans contradict them; else they are
  /// estimated.
  /// @param seed of all draws; those of a scan derive from (seed, scan sequence) alone.
  /// @param births where tracks begin in place of its own pairs of echoes; null: those.
  /// @throws std::invalid_argument on a parameter out of range.
  JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed,
               std::unique_ptr<BirthMethod> births = nullptr);

  std::span<const core::Track> update(const core::PosedScan& scan) override;
  std::optional<core::SensorEstimate> sensor_estimate() const override { return learning_.estimate(); }
  void explain_to(DecisionLog log) override { state_.log = std::move(log); }
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override;

 private:
  void take(const core::PosedScan& scan);

  JointTrackerParams params_;
  std::uint64_t seed_;
  JointState state_;
  JointUnseen unseen_;
  JointFilter filter_;
  JointHeading heading_;
  JointOnset onset_;
  JointEnding ending_;
  JointOutput output_;
  JointLearning learning_;
};

}  // namespace lookout::tracking
