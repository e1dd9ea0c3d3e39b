#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/random.hpp"
#include "core/sonar_params.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/joint/births.hpp"
#include "tracking/joint/confirmation.hpp"
#include "tracking/joint/deletion.hpp"
#include "tracking/joint/heading_correction.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/scan_update.hpp"
#include "tracking/joint/tracker_state.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// Tracks each target as a density over its trajectories, under the exact likelihood of the last minute of
/// scans, with odds of existence: multi-Bernoulli with one global hypothesis ([Williams2015]). Births are
/// what the joint estimator finds beyond the tracks; what is confirmed minimises the expected OSPA.
/// docs/joint_tracker.md.
class JointTracker : public Tracker {
 public:
  /// @param sonar its figures, where given, are used until the scans contradict them; others are estimated.
  /// @param seed of all draws; those of a scan derive from (seed, scan sequence) alone.
  /// @param proposals replaces the motion elements as the place where tracks begin; null: they are used.
  /// @throws std::invalid_argument on a parameter out of range.
  JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed,
               std::unique_ptr<BirthMethod> proposals = nullptr);

  csht::Explained take(const core::PosedScan& scan) override;
  std::span<const core::Track> update(const core::PosedScan& scan,
                                      std::span<const core::MotionElement> elements) override;
  std::optional<core::SensorEstimate> sensor_estimate() const override {
    return state_.learning().estimate();
  }
  bool learns_clutter() const override { return params_.clutter.map.enabled; }
  std::optional<core::ClutterGrid> clutter_grid() const override {
    return state_.clutter.grid(state_.likelihood);
  }
  bool explains() const override { return true; }
  void explain_to(const DecisionLog& log) override { state_.log = log; }
  void stop_when(const std::function<bool()>& stopped) override { state_.stopped = stopped; }
  std::int64_t next_id() const override { return state_.next_id(); }
  void set_next_id(std::int64_t id) override { state_.set_next_id(id); }
  bool can_retrodict() const override { return true; }
  std::span<const core::Track> retrodict(std::int64_t utime) override;

 private:
  JointTrackerParams params_;
  TrackerState state_;
  ScanUpdate scan_update_;
  HeadingCorrection heading_;
  Births births_;
  Deletion deletion_;
  Confirmation confirmation_;
};

}  // namespace lookout::tracking
