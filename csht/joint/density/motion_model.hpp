#pragma once

#include <Eigen/Core>

namespace lookout::csht {

/// How a trajectory moves: at constant velocity, at constant acceleration, or at constant speed and turn rate
/// ([BarShalom2001] Sec. 11.7, the coordinated turn).
enum class Motion { constant_velocity, constant_acceleration, constant_turn };

/// A trajectory at some time: position (north, east) [m], velocity [m/s] and what its motion needs beside:
/// the acceleration (north, east) [m/s^2], or the turn rate [rad/s], positive to starboard; else zero. Earth
/// frame.
using Trajectory = Eigen::Matrix<double, 6, 1>;
/// Of the components of a trajectory; rows and columns that its motion does not use count for nothing.
using TrajectoryCovariance = Eigen::Matrix<double, 6, 6>;

/// Components of a trajectory that its motion uses: 4, 6 (acceleration) or 5 (turn).
int dimensions(Motion motion);

/// Position (north, east) [m] on a trajectory `seconds` from its time; negative: before it.
Eigen::Vector2d position_at(Motion motion, const Trajectory& trajectory, double seconds);

/// Position [m] and velocity [m/s] on a trajectory `seconds` from its time, (north, east) each.
Eigen::Vector4d state_at(Motion motion, const Trajectory& trajectory, double seconds);

/// Mean and covariance of position [m] and velocity [m/s], north and east each, earth frame.
struct StateMoments {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();        ///< Position, then velocity.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of the same.
};
/// Those of a trajectory that is known with an error, `seconds` from its time, to first order: J P J^T with
/// the Jacobian J of the motion, [BarShalom2001] Sec. 11.7 for the turn.
StateMoments state_moments_at(Motion motion, const Trajectory& mean, const TrajectoryCovariance& covariance,
                              double seconds);

}  // namespace lookout::csht
