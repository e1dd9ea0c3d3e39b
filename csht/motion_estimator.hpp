#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

namespace lookout::csht {

class JointScene;
class LocalClutter;

/// What a tracker knows before the estimator looks at the next scan. Valid until the tracker is updated.
struct Explained {
  std::span<const core::Track> tracks;  ///< As they were at the scan of the last update.
  /// The tracker's own table of scans with the next scan in it, and what its tracks explain of them; null
  /// from trackers that keep none.
  JointScene* scene = nullptr;
  /// What the tracker has learnt of the density of false returns, the next scan priced in it; null: they are
  /// taken for uniform.
  const LocalClutter* clutter = nullptr;
};

/// The front door of every estimator: one scan in, the motion elements at that scan out.
class MotionEstimator {
 public:
  virtual ~MotionEstimator() = default;

  /// What the next `update` need not find again; methods without such a use ignore it.
  virtual void offer(const Explained& /*explained*/) {}

  /// Takes the next scan, later than all before it, and estimates the targets from the window that ends with
  /// it.
  /// @return valid until the next call; empty where nothing is found.
  virtual std::span<const core::MotionElement> update(const core::PosedScan& scan) = 0;

  /// The sensor's figures as the stream shows them; nothing from methods that do not estimate them.
  virtual std::optional<core::SensorEstimate> sensor_estimate() const { return std::nullopt; }

  virtual core::EstimatorMethod method() const = 0;  ///< As named on the wire.
  virtual int window_scans() const = 0;              ///< Scans in a full window.
};

}  // namespace lookout::csht
