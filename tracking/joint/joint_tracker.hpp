#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "csht/joint/evidence/undetected_targets.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/joint/births.hpp"
#include "tracking/joint/confirmation.hpp"
#include "tracking/joint/deletion.hpp"
#include "tracking/joint/heading_correction.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/scan_update.hpp"
#include "tracking/joint/sensor_learning.hpp"
#include "tracking/joint/tracker_state.hpp"
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
  TrackerState state_;
  csht::UndetectedTargets unseen_;
  ScanUpdate filter_;
  HeadingCorrection heading_;
  Births onset_;
  Deletion ending_;
  Confirmation output_;
  SensorLearning learning_;
};

}  // namespace lookout::tracking
