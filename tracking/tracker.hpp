#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "tracking/decision.hpp"

namespace lookout::tracking {

/// The front door of every tracker: one scan in, all its tracks at that scan out.
class Tracker {
 public:
  virtual ~Tracker() = default;

  /// Takes the next scan, later than all before it.
  /// @return tentative, confirmed and coasting tracks at the scan's time; valid until the next call.
  virtual std::span<const core::Track> update(const core::PosedScan& scan) = 0;

  /// The motion elements that the estimator behind the tracker found in the newest window; empty where none
  /// is used.
  virtual std::span<const core::MotionElement> elements() const { return {}; }

  /// Whether an estimator drives the tracker, so that it has elements of its own.
  virtual bool has_estimator() const { return false; }

  /// The sensor's figures as the tracker sees them after the newest scan; nothing from trackers that do not
  /// estimate them.
  virtual std::optional<core::SensorEstimate> sensor_estimate() const { return std::nullopt; }

  /// Sends every decision from now on to `log`. Trackers that keep no account of them ignore it.
  virtual void explain_to(DecisionLog /*log*/) {}

  /// Whether `retrodict` has something to say.
  virtual bool can_retrodict() const { return false; }

  /// The tracks at an earlier scan's time [us], at most a minute before the newest, as they are known by now:
  /// drawn back to their start, without those that proved false. Never a substitute for the online output.
  /// @return valid until the next call; empty from trackers that cannot.
  virtual std::span<const core::Track> retrodict(std::int64_t /*utime*/) { return {}; }
};

}  // namespace lookout::tracking
