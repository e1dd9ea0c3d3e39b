#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

namespace lookout::csht {

/// The front door of every estimator: one scan in, the motion elements at that scan out.
class MotionEstimator {
 public:
  virtual ~MotionEstimator() = default;

  /// Takes the next scan, later than all before it, and estimates the targets from the window that ends with
  /// it.
  /// @return valid until the next call; empty where nothing is found.
  virtual std::span<const core::MotionElement> update(const core::PosedScan& scan) = 0;

  /// Tracks offered as extra candidates to the next `update`, as they were at the scan of the last one;
  /// methods without such a use ignore them.
  virtual void offer(std::span<const core::Track> /*tracks*/) {}

  /// The sensor's figures as the stream shows them; nothing from methods that do not estimate them.
  virtual std::optional<core::SensorEstimate> sensor_estimate() const { return std::nullopt; }

  virtual core::EstimatorMethod method() const = 0;
  virtual int window_scans() const = 0;  ///< Scans in a full window.
};

}  // namespace lookout::csht
