#pragma once

#include <string_view>

#include "core/pose_history.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_limits.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

/// What is asked of a ping before it may reach a tracker. A defect is the reason to reject it, empty for
/// none.
namespace lookout::tracking {

/// Bounds beyond which a message cannot be what it claims, and would ask for absurd memory.
struct PingLimits {
  /// Beams of a ping.
  static constexpr int kMaxBeams = core::SonarLimits::kMaxBeams;
  static constexpr double kMaxRange = core::SonarLimits::kMaxRange;  ///< [m]
  static constexpr double kMaxMount = core::SonarLimits::kMaxMount;  ///< [m]
  static constexpr double kMaxPosition = 1e8;  ///< Of a vehicle from the earth frame's origin [m].
  static constexpr double kMaxSpeed = core::SonarLimits::kMaxSpeed;  ///< Of a vehicle [m/s].
  static constexpr double kMaxAngle = 1e3;                           ///< Of a heading or bearing [rad].
  /// Beams x bins of an image.
  static constexpr std::size_t kMaxPixels = core::SonarLimits::kMaxPixels;
};

/// NaN or infinite in a header, a time, size or geometry out of range. Returns are not looked at.
std::string_view defect(const core::SonarScan& scan);
std::string_view defect(const core::SonarImage& image);    ///< Likewise.
std::string_view defect(const core::VehicleState& state);  ///< Likewise.

/// The beam whose centre is nearest to a bearing [rad] of the sonar frame; outside the fan one that is not
/// there.
int beam_of(const core::SonarScan& scan, double bearing);

/// Returns that were taken out of a ping.
struct DroppedReturns {
  int silent = 0;  ///< NaN, infinite or of range 0, and three or more at the very maximum: how drivers say
                   ///< that a beam heard nothing.
  int out_of_bounds = 0;  ///< Beyond the maximum range, of a negative range, or outside the sector.
};

/// Takes those returns out of a scan without defect, and turns the bearings of the rest to within half a turn
/// of the sector's middle; an intensity that is not finite is one that nobody knows, 1. An image has none.
DroppedReturns drop_returns(core::SonarScan& scan);
/// Likewise.
DroppedReturns drop_returns(core::SonarImage& image);

/// Returns of one scan that have one and the same range.
struct SameRange {
  double range = 0.0;  ///< [m]
  int count = 0;       ///< 0: there are none.
};
/// More than half of the returns, of eight or more, at one range to the bit: no echoes do that. What a driver
/// says in place of silence, as a value of its own, looks so. An image has none.
SameRange same_range(const core::SonarScan& scan);
/// Likewise.
SameRange same_range(const core::SonarImage& image);

/// Fan, ranges and mount of a ping; of uneven beams the mean spacing.
struct PingGeometry {
  core::Pose2 T_body_sonar;                        ///< Mount: forward, starboard [m], heading [rad].
  double first_bearing = 0.0, bearing_step = 0.0;  ///< [rad]
  double max_range = 0.0;                          ///< Of the outermost range [m].
  int num_beams = 0;                               ///< >= 1.
};
/// What the ping was taken with.
PingGeometry geometry_of(const core::SonarScan& scan);
/// What the ping was taken with.
PingGeometry geometry_of(const core::SonarImage& image);
/// Whether they agree but for rounding.
bool same(const PingGeometry& a, const PingGeometry& b);

/// Whether the geometry in the message is that of the configuration.
bool agrees(const core::SonarScan& scan, const core::SonarParams& configured);
bool agrees(const core::SonarImage& image, const core::SonarParams& configured);  ///< Likewise.

}  // namespace lookout::tracking
