#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/clutter_grid.hpp"
#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "csht/motion_estimator.hpp"
#include "tracking/decision.hpp"

namespace lookout::tracking {

/// The front door of every tracker: one scan and its motion elements in, all its tracks at that scan out.
/// Called by ScanPipeline: `take`, then `update`, once for each scan.
class Tracker {
 public:
  virtual ~Tracker() = default;

  /// Takes the next scan, later than all before it, into the tracks that there are.
  /// @return what they explain, which the estimator is offered; valid until `update`. Trackers that look at
  /// the scan in `update` alone explain nothing.
  virtual csht::Explained take(const core::PosedScan& /*scan*/) { return {}; }

  /// Ends the scan: what the elements say is taken in, tracks begin and end.
  /// @param scan the one that `take` had. @param elements what the estimator made of it.
  /// @return tentative, confirmed and coasting tracks at the scan's time; valid until the next call.
  virtual std::span<const core::Track> update(const core::PosedScan& scan,
                                              std::span<const core::MotionElement> elements) = 0;

  /// The sensor's figures as the tracker sees them after the newest scan; nothing from trackers that do not
  /// estimate them.
  virtual std::optional<core::SensorEstimate> sensor_estimate() const { return std::nullopt; }

  /// Whether `clutter_grid` has something to say, once there are scans.
  virtual bool learns_clutter() const { return false; }

  /// What the tracker has learnt of its clutter, around the sonar of the newest scan; nothing from trackers
  /// that take it for uniform. It costs some milliseconds.
  virtual std::optional<core::ClutterGrid> clutter_grid() const { return std::nullopt; }

  /// Whether `explain_to` has something to say.
  virtual bool explains() const { return false; }

  /// Sends every decision from now on to `log`. Trackers that keep no account of them ignore it.
  virtual void explain_to(const DecisionLog& /*log*/) {}

  /// The identity that the next new track gets; identities go on from `set_next_id`, before the first scan.
  virtual std::int64_t next_id() const = 0;
  virtual void set_next_id(std::int64_t id) = 0;  ///< See `next_id`.

  /// `stopped` is asked again and again within the work on a scan. Once it is true the rest is left undone,
  /// what comes of the scan means nothing, and no other may follow. Trackers whose scans are short ignore it.
  virtual void stop_when(const std::function<bool()>& /*stopped*/) {}

  /// Whether `retrodict` has something to say.
  virtual bool can_retrodict() const { return false; }

  /// The tracks at an earlier scan's time [us], at most a minute before the newest, as they are known by now:
  /// drawn back to their start, without those that proved false. Never a substitute for the online output.
  /// @return valid until the next call; empty from trackers that cannot.
  virtual std::span<const core::Track> retrodict(std::int64_t /*utime*/) { return {}; }
};

}  // namespace lookout::tracking
