#pragma once

#include "csht/joint/density/trajectory_cloud.hpp"

namespace lookout::csht {

/// When a track surely moves over ground: its velocity is off rest by more than its own errors allow, however
/// slow it is. Beside the creep nothing but the accuracy of the velocity says what is slow
/// (docs/clutter_map.md).
struct MoverParams {
  double sigmas = 3.0;  ///< A track surely moves whose velocity is so many standard deviations off rest, > 0.
  /// What stands may seem to creep, by errors of navigation: standard deviation of each component of its
  /// velocity [max speed], > 0. In the 60 s that the paper's sonar remembers .003 are a fifth of a range
  /// sigma.
  double creep = 0.003;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const MoverParams& params);

/// Mahalanobis distance of a track's velocity from rest, its covariance widened by the creep [standard
/// deviations].
/// @param moments of its trajectory. @param creep [m/s], > 0.
double sigmas_off_rest(const CloudMoments& moments, double creep);

/// Whether it surely moves. @param max_speed of targets [m/s], > 0.
bool surely_moves(const CloudMoments& moments, const MoverParams& params, double max_speed);

}  // namespace lookout::csht
