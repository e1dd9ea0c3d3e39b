#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace lookout::fusion {

/// What a node says of one of its tracks: one message of the thin link, earth frame.
struct LocalEstimate {
  std::int64_t utime = 0;                     ///< Of the estimate, on the node's clock [us].
  std::int64_t sequence = 0;                  ///< Number of the scan behind it.
  std::int32_t node_id = 0;                   ///< Who sends it.
  Eigen::Vector2d p_earth_node{0, 0};         ///< Where its sensor stood: north, east [m].
  std::int64_t track_id = 0;                  ///< The node's own number of the track.
  Eigen::Vector4d state{0, 0, 0, 0};          ///< North, east [m], north velocity, east velocity [m/s].
  std::optional<Eigen::Matrix4d> covariance;  ///< Of `state`, for the methods that need it.
};

/// The bounds outside of which an estimate cannot be meant.
struct EstimateLimits {
  double max_coordinate = 1e6;  ///< Of a north or east position, of target or node [m], > 0. Own choice.
  double max_speed = 1e3;       ///< Of a target [m/s], > 0. Own choice.
};

/// Whether all numbers are finite and within `limits`, and the covariance, where given, is symmetric and
/// positive definite.
bool is_plausible(const LocalEstimate& estimate, const EstimateLimits& limits);

}  // namespace lookout::fusion
