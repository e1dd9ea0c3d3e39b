#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/sonar_scan.hpp"
#include "csht/motion_estimator.hpp"
#include "tracking/ping_result.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// The one flow of every method, a scan at a time: scan -> estimator -> motion elements -> tracker -> tracks.
/// The tracker takes the scan into the tracks that it has, and the estimator is offered what they explain;
/// what it finds beyond, the tracker may begin.
///
/// The returns of some sensors are old when their scan is stamped (SonarParams::latency): all works at the
/// time when they were made, and what comes out is moved on to the time of the scan.
class ScanPipeline {
 public:
  /// @param estimator null: none runs, and the tracker has no elements. @param tracker must be set.
  /// @param latency age of the returns at the time of their scan [us], >= 0.
  ScanPipeline(std::unique_ptr<csht::MotionEstimator> estimator, std::unique_ptr<Tracker> tracker,
               std::int64_t latency = 0);

  /// Takes the next scan, later than all before it. @return its results; valid until the next call.
  PingResult step(const core::PosedScan& scan);

  /// The tracks at an earlier scan's time [us], as they are known by now; see Tracker::retrodict.
  std::span<const core::Track> retrodict(std::int64_t utime);
  bool can_retrodict() const { return tracker_->can_retrodict(); }  ///< See Tracker.

  bool learns_clutter() const { return tracker_->learns_clutter(); }  ///< See Tracker.
  std::optional<core::ClutterGrid> clutter_grid() const;  ///< See Tracker, with the time of the scan.
  void explain_to(const DecisionLog& log);  ///< See Tracker::explain_to; times are those of the scans.
  void stop_when(const std::function<bool()>& stopped) { tracker_->stop_when(stopped); }  ///< See Tracker.
  std::int64_t next_id() const { return tracker_->next_id(); }                            ///< See Tracker.
  void set_next_id(std::int64_t id) { tracker_->set_next_id(id); }                        ///< See Tracker.

 private:
  const core::PosedScan& at_time_of_returns(const core::PosedScan& scan);
  std::span<const core::MotionElement> estimate(const core::PosedScan& scan);
  std::span<const core::Track> bring_to_scan(std::span<const core::Track> tracks, double seconds);
  std::span<const core::MotionElement> bring_to_scan(std::span<const core::MotionElement> elements);
  PingResult describe(const core::PosedScan& scan) const;

  std::unique_ptr<csht::MotionEstimator> estimator_;
  std::unique_ptr<Tracker> tracker_;
  std::int64_t latency_;
  std::int32_t sensor_id_ = 0;  ///< Of the newest scan.
  core::PosedScan scan_;        ///< The newest, at the time of its returns.
  std::vector<core::MotionElement> elements_;
  std::vector<core::Track> tracks_;
};

}  // namespace lookout::tracking
