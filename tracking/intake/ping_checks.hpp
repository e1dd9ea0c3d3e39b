#pragma once

#include <string_view>

#include "core/pose_history.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

/// What is asked of a ping before it may reach a tracker. A defect is the reason to reject it, empty for
/// none.
namespace lookout::tracking {

/// Bounds beyond which a message cannot be what it claims, and would ask for absurd memory.
struct PingLimits {
  static constexpr int kMaxBeams = 30'000;              ///< Beams of a scan or an image.
  static constexpr double kMaxRange = 50'000.0;         ///< [m], beyond any active sonar or small-boat radar.
  static constexpr double kMaxMount = 1'000.0;          ///< Of the sonar from the body's origin [m].
  static constexpr double kMaxPosition = 1e8;           ///< Of a vehicle from the earth frame's origin [m].
  static constexpr double kMaxSpeed = 1e4;              ///< Of a vehicle [m/s].
  static constexpr double kMaxAngle = 1e3;              ///< Of a heading or bearing [rad].
  static constexpr std::size_t kMaxPixels = 1'000'000;  ///< Beams x bins of an image.
};

/// Why a message cannot be used; empty where it can. NaN or infinite anywhere, a time, size or geometry out
/// of range.
std::string_view defect(const core::SonarScan& scan);
std::string_view defect(const core::SonarImage& image);    ///< Likewise.
std::string_view defect(const core::VehicleState& state);  ///< Likewise.

/// Removes the returns of a scan without defect that lie outside (0, max_range] or outside the sector, and
/// turns the bearings of the rest to within half a turn of the sector's middle. An image has none. Returns
/// how many went.
int drop_out_of_bounds(core::SonarScan& scan);
int drop_out_of_bounds(core::SonarImage& image);  ///< Always 0.

/// Whether the geometry in the message is that of the configuration.
bool agrees(const core::SonarScan& scan, const core::SonarParams& configured);
bool agrees(const core::SonarImage& image, const core::SonarParams& configured);  ///< Likewise.

}  // namespace lookout::tracking
