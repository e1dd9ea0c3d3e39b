#pragma once

#include "csht/joint/density/trajectory_cloud.hpp"

namespace lookout::tracking {

/// When a track is taken for something that stands still over ground.
struct StandingParams {
  bool report = true;  ///< Report what stands, too.
  /// What stands may seem to creep: standard deviation of each component of its velocity [max speed], > 0. A
  /// target must be several times faster to count as moving.
  double creep = 1.0 / 30.0;
};

/// Probability that a track moves over ground, by the Savage-Dickey ratio: the density of its velocity at
/// zero (blurred by the creep) after its scans over that before them is the Bayes factor for standing.
/// [Dickey1971].
/// @param moments of its trajectory. @param velocity_sigma of each component before its scans [m/s], > 0.
/// @param creep [m/s], > 0. @param standing_share probability that a thing stands, before its scans, in (0,
/// 1).
double moving_probability(const csht::CloudMoments& moments, double velocity_sigma, double creep,
                          double standing_share);

}  // namespace lookout::tracking
