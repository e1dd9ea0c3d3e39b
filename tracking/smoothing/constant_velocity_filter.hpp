#pragma once

#include <Eigen/Core>

#include "core/track.hpp"

namespace lookout::tracking {

/// How a target moves between scans: constant velocity disturbed by white acceleration.
struct MotionModelParams {
  double acceleration_sigma = 0.1;  ///< Standard deviation of the acceleration [m/s^2], >= 0.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// Carries the state of `track` and its covariance `seconds` >= 0 ahead. The acceleration is constant over
/// the step and drawn anew for the next. [BarShalom2001] Eq. (6.3.2-2), (6.3.2-4).
void predict(core::Track& track, double seconds, const MotionModelParams& motion);

/// Kalman update with a position: the state moves by the gain times the residual, the covariance is kept
/// symmetric and positive by Joseph's form. [BarShalom2001] Sec. 5.2.
/// @param position measured north, east [m]; @param noise its covariance [m^2], positive definite.
void update(core::Track& track, const Eigen::Vector2d& position, const Eigen::Matrix2d& noise);

}  // namespace lookout::tracking
