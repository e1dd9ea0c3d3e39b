#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/sonar_params.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// A tracker of a sensor whose returns are old when their scan is stamped (SonarParams::latency): the tracker
/// within works at the time when the returns were made; what it says is moved on to the time of the scan.
class LateScanTracker : public Tracker {
 public:
  /// @param latency age of the returns at the time of their scan [us], > 0.
  LateScanTracker(std::unique_ptr<Tracker> tracker, std::int64_t latency);

  std::span<const core::Track> update(const core::PosedScan& scan) override;
  std::span<const core::MotionElement> elements() const override { return elements_; }
  bool has_estimator() const override { return tracker_->has_estimator(); }
  std::optional<core::SensorEstimate> sensor_estimate() const override { return tracker_->sensor_estimate(); }
  void explain_to(DecisionLog log) override;
  bool can_retrodict() const override { return tracker_->can_retrodict(); }
  std::span<const core::Track> retrodict(std::int64_t utime) override;

 private:
  void move_on(std::span<const core::Track> tracks, double seconds);
  void move_on(std::span<const core::MotionElement> elements, double seconds);

  std::unique_ptr<Tracker> tracker_;
  std::int64_t latency_;
  core::PosedScan scan_;  ///< The newest, at the time of its returns.
  std::vector<core::Track> tracks_;
  std::vector<core::MotionElement> elements_;
};

/// The tracker, in a LateScanTracker where the sensor has a latency. @param tracker must be set.
std::unique_ptr<Tracker> make_up_for_latency(std::unique_ptr<Tracker> tracker,
                                             const core::SonarParams& sonar);

}  // namespace lookout::tracking
