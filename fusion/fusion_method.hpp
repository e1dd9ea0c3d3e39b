#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fusion/local_track.hpp"

namespace lookout::fusion {

/// One node's tracklet that was associated with a global track.
struct Contribution {
  const LocalTrack* track = nullptr;    ///< Its estimates; never null.
  Eigen::Vector4d current{0, 0, 0, 0};  ///< Its newest estimate carried to the time of fusion.
};

/// A global track at the time of fusion and the tracklets that support it.
struct TrackGroup {
  std::int64_t global_id = 0;               ///< Of the global track.
  std::int64_t utime = 0;                   ///< Time of fusion [us].
  bool is_new = false;                      ///< Begun at this time: there is no prediction to compare with.
  Eigen::Vector4d previous{0, 0, 0, 0};     ///< Fused state of the last time, [Li2018] Eq. (15).
  Eigen::Vector4d predicted{0, 0, 0, 0};    ///< That state carried to `utime`, Eq. (16).
  std::vector<Contribution> contributions;  ///< One or more.
};

/// The fused state of one group.
struct FusedState {
  /// North, east [m], north and east velocity [m/s] at the time of fusion.
  Eigen::Vector4d state{0, 0, 0, 0};
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Zero from methods that state none.
};

/// A way to fuse the estimates that support each global track. One object serves one run, and may learn.
class FusionMethod {
 public:
  virtual ~FusionMethod() = default;

  /// Fuses every group of one time, later than all before it. Each group has at least one contribution.
  /// @return one state per group, in their order; valid until the next call.
  virtual std::span<const FusedState> fuse(std::span<const TrackGroup> groups) = 0;

  /// Whether it fuses only estimates that carry a covariance.
  virtual bool needs_covariance() const { return false; }

  /// Forgets everything learned: a new clock has begun.
  virtual void reset() {}
};

}  // namespace lookout::fusion
