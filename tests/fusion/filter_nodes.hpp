#pragma once

#include <Eigen/LU>

#include "core/constant_velocity.hpp"
#include "fusion/methods/maximum_likelihood_fusion.hpp"
#include "tests/fusion/test_nodes.hpp"

/// Nodes that send covariances, for the methods that need them.
namespace lookout::fusion::testing {

/// A node's two estimates with the covariance diag(a, b, 1, 1).
inline LocalTrack with_covariance(std::int32_t node, const Eigen::Vector4d& state, double a, double b) {
  LocalTrack track = tracklet(node, state);
  LocalEstimate older = track.back(1), newer = track.newest();
  older.covariance = newer.covariance = Eigen::Vector4d(a, b, 1, 1).asDiagonal().toDenseMatrix();
  LocalTrack result(older);
  result.append(newer);
  return result;
}

/// What `method` makes of one group of these tracks.
inline FusedState fuse(FusionMethod& method, const std::vector<LocalTrack>& tracks) {
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  return method.fuse(groups).front();
}

/// One node's linear Kalman filter of a target, with position noise of variance `r` in both axes.
struct Node {
  double r;
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();

  void start(const Eigen::Vector2d& z, double velocity_sigma) {
    state << z, 0.0, 0.0;
    covariance.diagonal() << r, r, velocity_sigma * velocity_sigma, velocity_sigma * velocity_sigma;
  }
  void predict(const KalmanModel& model) {
    state = core::moved(state, 1.0);
    covariance = core::constant_velocity_transition(1.0) * covariance *
                     core::constant_velocity_transition(1.0).transpose() +
                 core::white_acceleration_noise(1.0, model.process_noise);
  }
  void correct(const Eigen::Vector2d& z, double variance) {
    const Eigen::Matrix2d innovation =
        covariance.topLeftCorner<2, 2>() + variance * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
    state += gain * (z - state.head<2>());
    covariance -= (gain * covariance.topRows<2>()).eval();
    covariance = (0.5 * (covariance + covariance.transpose())).eval();
  }
};

/// What it sends at second `k`.
inline LocalEstimate message(const Node& node, std::int32_t id, int k) {
  LocalEstimate result = estimate(id, 1, k, node.state);
  result.covariance = node.covariance;
  return result;
}

}  // namespace lookout::fusion::testing
