#pragma once

#include <Eigen/Core>

namespace lookout::csht {

/// How a trajectory moves: straight on, with a constant acceleration, or at a constant speed and turn rate.
enum class Motion { line, bend, turn };

/// A trajectory at some time: position, velocity and then what its motion needs: of a bend the acceleration
/// (north, east), of a turn its rate [rad/s], positive to starboard; else zero. Earth frame, SI.
using Trajectory = Eigen::Matrix<double, 6, 1>;
using TrajectoryCovariance = Eigen::Matrix<double, 6, 6>;

/// Components of a trajectory that its motion uses: 4, 6 or 5.
int dimensions(Motion motion);

/// Position on a trajectory `seconds` from its time.
Eigen::Vector2d position_at(Motion motion, const Trajectory& trajectory, double seconds);

/// Position and velocity on a trajectory `seconds` from its time.
Eigen::Vector4d state_at(Motion motion, const Trajectory& trajectory, double seconds);

/// Mean and covariance of position and velocity, to first order.
struct StateMoments {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
};
StateMoments state_moments_at(Motion motion, const Trajectory& mean, const TrajectoryCovariance& covariance,
                              double seconds);

}  // namespace lookout::csht
