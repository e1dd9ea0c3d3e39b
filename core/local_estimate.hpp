#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace lookout::core {

/// One track of one vehicle as it is sent to the others, earth frame.
struct LocalEstimate {
  std::int64_t utime = 0;                     ///< Of the estimate [us].
  std::int64_t sequence = 0;                  ///< Of the scan behind it.
  std::int32_t node_id = 0;                   ///< Of the vehicle that sends.
  Eigen::Vector2d p_earth_node{0, 0};         ///< Where its sensor stood: north, east [m].
  std::int64_t track_id = 0;                  ///< Unique at that vehicle.
  Eigen::Vector4d state{0, 0, 0, 0};          ///< North, east [m], north velocity, east velocity [m/s].
  std::optional<Eigen::Matrix4d> covariance;  ///< Of `state`, SI; absent where the method needs none.
};

}  // namespace lookout::core
