#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/clutter_grid.hpp"
#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// All that the chain says of one accepted ping, a scan or an image; the one struct between tracker and wire.
/// Its spans are valid until the callback that receives it returns.
struct PingResult {
  std::int64_t utime = 0;                         ///< Of the ping [us].
  std::int64_t sequence = 0;                      ///< Likewise.
  std::int32_t sensor_id = 0;                     ///< Likewise.
  Eigen::Vector2d p_earth_sonar{0, 0};            ///< Where it was taken: north, east [m].
  std::span<const core::MotionElement> elements;  ///< What the estimator found.
  std::span<const core::Track> tracks;            ///< At the ping's time; with a lag, as known so much later.
  std::optional<core::SensorEstimate> sensor_estimate;  ///< Of methods that estimate the sensor's figures.
  /// What has been learnt of the clutter up to the newest ping, for who wants to know: see
  /// Tracker::clutter_grid. May be empty.
  std::function<std::optional<core::ClutterGrid>()> clutter_grid;
  core::EstimatorMethod method = core::EstimatorMethod::csht;  ///< Of the estimator that ran.
  int window_scans = 0;                                        ///< Of its full window; 0 where none ran.
};

}  // namespace lookout::tracking
