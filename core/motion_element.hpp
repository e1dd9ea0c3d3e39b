#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace lookout::core {

/// What an estimator says of one target at the newest scan of its window, earth frame.
struct MotionElement {
  std::int64_t initial_utime = 0;          ///< Start of its window [us].
  Eigen::Vector2d initial_position{0, 0};  ///< North, east [m] at `initial_utime`.
  Eigen::Vector2d velocity{0, 0};          ///< North, east [m/s].
  Eigen::Vector2d position{0, 0};          ///< North, east [m] at the newest scan.
  Eigen::Matrix4d covariance =
      Eigen::Matrix4d::Zero();  ///< Of (north, east, north velocity, east velocity), SI.
  double score = 0.0;           ///< The method's own ranking, larger is better.
  double existence = 1.0;       ///< Probability that the target exists; 1 from methods without one.
  int support = 0;              ///< Detections that belong to it.
  bool of_known_track = false;  ///< Accepted only because a track was offered: no proof of a new target. Not
                                ///< on the wire.

  /// Where the joint engine keeps the density behind the element; -1 from other methods. Not on the wire.
  int hypothesis = -1;

  /// (north, east, north velocity, east velocity) at the newest scan.
  Eigen::Vector4d state() const { return {position.x(), position.y(), velocity.x(), velocity.y()}; }
};

/// The numbers of the estimators, as on the wire (motion_elements_t.method). An estimator from outside the
/// library is `other`: the registry names it, the wire does not.
enum class EstimatorMethod : std::int8_t {
  csht = 0,
  sht = 1,
  joint = 2,
  ransac = 3,
  h_pmht = 4,
  csht_printed = 5,
  other = 127
};

}  // namespace lookout::core
