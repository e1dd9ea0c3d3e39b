#pragma once

namespace lookout::core {

/// Beyond these a description of a sonar cannot be what it claims, or would ask for gigabytes (windows of
/// scans, grids of ranges): the same for a message, a recording and a configuration.
struct SonarLimits {
  static constexpr int kMaxBeams = 30'000;        ///< Of one ping.
  static constexpr int kMaxBins = 32'767;         ///< Range bins of an image: the wire counts in 16 bits.
  static constexpr int kMaxPixels = 4'194'304;    ///< Beams x bins of an image.
  static constexpr double kMinRange = 0.1;        ///< Of the maximum range [m].
  static constexpr double kMaxRange = 200'000.0;  ///< [m], beyond any active sonar or coastal radar.
  static constexpr double kMaxMount = 1'000.0;    ///< Of the sonar from the body's origin [m].
  static constexpr double kMinRangeSigma = 5e-3, kMaxRangeSigma = 5e3;  ///< [m]
  static constexpr double kMaxSpeed = 1e4;  ///< Of targets and of a vehicle [m/s].
  static constexpr double kMinScanPeriod = 5e-3, kMaxScanPeriod = 3'600.0;  ///< [s]
};

}  // namespace lookout::core
