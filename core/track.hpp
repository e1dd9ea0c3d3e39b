#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace lookout::core {

/// coasting: outside the field of view and kept; a track that is missed in view stays confirmed.
enum class TrackStatus : std::int8_t { tentative = 0, confirmed = 1, coasting = 2 };

/// "tentative", "confirmed" or "coasting".
inline const char* to_string(TrackStatus status) {
  switch (status) {
    case TrackStatus::tentative:
      return "tentative";
    case TrackStatus::confirmed:
      return "confirmed";
    case TrackStatus::coasting:
      return "coasting";
  }
  return "unknown";
}

/// One track at the newest scan, earth frame.
struct Track {
  std::int64_t id = 0;                          ///< Unique within a run of the tracker, never used again.
  TrackStatus status = TrackStatus::tentative;  ///< How sure the tracker is of it.
  Eigen::Vector4d state{0, 0, 0, 0};            ///< North, east [m], north velocity, east velocity [m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `state`, SI.
  double existence = 0.0;                                ///< Probability that there is a target.
  double moving = 1.0;                    ///< Probability that it moves over ground; 1 from methods without.
  std::int64_t first_utime = 0;           ///< When the track began [us].
  std::int64_t last_detection_utime = 0;  ///< When it last had a detection of its own [us].

  Eigen::Vector2d position() const { return state.head<2>(); }  ///< North, east [m].
  Eigen::Vector2d velocity() const { return state.tail<2>(); }  ///< North, east [m/s].
};

}  // namespace lookout::core
