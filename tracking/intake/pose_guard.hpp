#pragma once

#include <optional>
#include <string_view>

#include "core/pose_history.hpp"
#include "tracking/intake/leap_guard.hpp"

namespace lookout::tracking {

/// When a pose leaps. All are choices of ours.
struct PoseGuardParams {
  /// Of the position [m], beside what the velocity says: more than a fix corrects dead reckoning by, and what
  /// a velocity that is not filled in leaves.
  LeapGuardParams position{.leap = 20.0, .rate = 10.0};
  /// Of the heading [rad]: 45 degrees at once and 90 a second, more than a vehicle turns.
  LeapGuardParams heading{.leap = 0.785, .rate = 1.57};
};

/// Notices navigation that contradicts itself: a position that leaps against its own velocity and time, a
/// heading that no vehicle can turn to: another unit or origin, a damaged fix. Meanwhile the place is
/// reckoned on from the last believed one by the stated velocities, and the heading stays; what comes back
/// near them is believed at once.
class PoseGuard {
 public:
  /// Knows nothing yet.
  explicit PoseGuard(const PoseGuardParams& params = {});

  /// Takes the next state whose time is believed; it may be a little late. @return what leaps; empty:
  /// nothing.
  std::string_view doubt(const core::VehicleState& state);
  void forget() { *this = PoseGuard(params_); }  ///< A new clock: nothing is known.

 private:
  core::Pose2 reckoned_at(const core::VehicleState& state) const;

  PoseGuardParams params_;
  LeapGuard position_, heading_;
  std::optional<core::VehicleState> newest_;  ///< Believed or not.
  core::Pose2 line_;                          ///< Of the vehicle by what is believed, at its time.
};

}  // namespace lookout::tracking
