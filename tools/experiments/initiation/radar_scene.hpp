#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/random.hpp"
#include "fusion/estimate_limits.hpp"

/// The scene of [Li2018]: four radars at the corners of a square, four aircraft, a Kalman filter at each
/// radar.
namespace lookout::tools {

/// What is wrong with the radar at (19, 19) km.
enum class RadarFault {
  none,
  worse,  ///< Range and azimuth noise five times as large; its filter knows.
  bias    ///< One degree of azimuth bias that nobody knows of.
};

struct RadarSceneParams {
  double azimuth_sigma = 0.05;  ///< Of each radar [rad], > 0.
  RadarFault fault = RadarFault::none;
  int num_targets = 4;         ///< The first of the four, 1 to 4.
  double process_noise = 1.0;  ///< White acceleration q of the targets, known to the filters [m^2/s^3], >= 0.
};

inline constexpr int kNumRadars = 4;
inline constexpr int kFaultyRadar = 3;                ///< Node id of the one at (19, 19) km.
inline constexpr int kRadarScans = 26;                ///< Until the targets leave the radars' square.
inline constexpr double kRadarScanPeriod = 2.0;       ///< [s]
inline constexpr double kRadarVelocitySigma = 300.0;  ///< Of the velocity that a filter starts with [m/s].

/// State with which target 0 to 3 starts: metres, metres per second, the paper's x as north.
Eigen::Vector4d radar_target(int target);

/// One scan of all radars.
struct RadarScan {
  std::vector<Eigen::Vector4d> truth;  ///< Of each target.
  /// Radar 1's targets in order, then radar 2's, ... Track ids are target + 1; each carries its covariance.
  std::vector<fusion::LocalEstimate> estimates;
};

/// All scans of one run. @throws std::invalid_argument on a parameter out of range.
std::vector<RadarScan> simulate_radars(const RadarSceneParams& params, core::Random& random);

}  // namespace lookout::tools
