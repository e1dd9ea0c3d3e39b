#include "csht/joint/density/motion_model.hpp"

#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kRateStep = 1e-5;  // Step of the difference quotient by the turn rate [rad/s].

Eigen::Matrix2d rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

double sinc(double angle) {
  return std::abs(angle) < 1e-4 ? 1.0 - angle * angle / 6.0 : std::sin(angle) / angle;
}

// Derivative of position and velocity after `seconds` by the trajectory: [BarShalom2001] Sec. 11.7 for the
// turn, its last column by a difference quotient.
using Transition = Eigen::Matrix<double, 4, 6>;

Transition transition(Motion motion, const Trajectory& mean, double seconds) {
  Transition result = Transition::Zero();
  result.topLeftCorner<2, 2>().setIdentity();
  if (motion == Motion::constant_turn) {
    const double half = 0.5 * mean[4] * seconds;
    result.block<2, 2>(0, 2) = seconds * sinc(half) * rotation(half);
    result.block<2, 2>(2, 2) = rotation(2.0 * half);
    const Trajectory step = kRateStep * Trajectory::Unit(4);
    result.col(4) =
        (state_at(motion, mean + step, seconds) - state_at(motion, mean - step, seconds)) / (2.0 * kRateStep);
    return result;
  }
  result.block<2, 2>(0, 2).diagonal().setConstant(seconds);
  result.block<2, 2>(2, 2).setIdentity();
  if (motion == Motion::constant_velocity) return result;
  result.block<2, 2>(0, 4).diagonal().setConstant(0.5 * seconds * seconds);
  result.block<2, 2>(2, 4).diagonal().setConstant(seconds);
  return result;
}

}  // namespace

int dimensions(Motion motion) {
  return motion == Motion::constant_velocity ? 4 : motion == Motion::constant_turn ? 5 : 6;
}

Eigen::Vector2d position_at(Motion motion, const Trajectory& trajectory, double seconds) {
  const auto position = trajectory.head<2>(), velocity = trajectory.segment<2>(2);
  if (motion == Motion::constant_turn) {
    const double half = 0.5 * trajectory[4] * seconds;
    return position + seconds * sinc(half) * (rotation(half) * velocity);
  }
  return position + seconds * velocity + 0.5 * seconds * seconds * trajectory.tail<2>();
}

Eigen::Vector4d state_at(Motion motion, const Trajectory& trajectory, double seconds) {
  Eigen::Vector4d state;
  state.head<2>() = position_at(motion, trajectory, seconds);
  const auto velocity = trajectory.segment<2>(2);
  if (motion == Motion::constant_turn)
    state.tail<2>() = rotation(trajectory[4] * seconds) * velocity;
  else
    state.tail<2>() = velocity + seconds * trajectory.tail<2>();
  return state;
}

StateMoments state_moments_at(Motion motion, const Trajectory& mean, const TrajectoryCovariance& covariance,
                              double seconds) {
  const Transition by = transition(motion, mean, seconds);
  return {state_at(motion, mean, seconds), by * covariance * by.transpose()};
}

}  // namespace lookout::csht
