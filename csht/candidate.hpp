#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace lookout::csht {

/// Most scans that a window may hold; candidates keep one detection a scan in place.
inline constexpr int kMaxWindowScans = 100;

/// A target that may be there: a straight course and the detections that it explains.
struct Candidate {
  Eigen::Vector4d state{0, 0, 0, 0};  ///< North, east [m] at the epoch, north and east velocity [m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `state`.
  std::array<int, kMaxWindowScans> own = none();  ///< Per scan the index of its detection, -1 for none.
  int support = 0;                                ///< How many scans have a detection of its own.
  double log_evidence = 0.0;                      ///< Log evidence for a target against clutter [nats].
  /// Offered by a confirmed track. Of an accepted candidate: accepted for that alone, on evidence that would
  /// not make a new target.
  bool offered = false;

  /// No detection in any scan.
  static constexpr std::array<int, kMaxWindowScans> none() {
    std::array<int, kMaxWindowScans> own{};
    own.fill(-1);
    return own;
  }

  /// Position [m] at `time` [s] after the epoch.
  Eigen::Vector2d position(double time) const { return state.head<2>() + time * state.tail<2>(); }
};

}  // namespace lookout::csht
