#include "fusion/estimate_limits.hpp"

#include <Eigen/Cholesky>

namespace lookout::fusion {
namespace {

bool is_covariance(const Eigen::Matrix4d& matrix) {
  if (!matrix.allFinite()) return false;
  const double asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > 1e-6 * matrix.cwiseAbs().maxCoeff()) return false;
  return Eigen::LLT<Eigen::Matrix4d>(matrix).info() == Eigen::Success;
}

bool is_near(const Eigen::Vector2d& p_earth, double max_coordinate) {
  return p_earth.allFinite() && p_earth.cwiseAbs().maxCoeff() <= max_coordinate;
}

}  // namespace

bool is_plausible(const LocalEstimate& estimate, const EstimateLimits& limits) {
  if (!is_near(estimate.state.head<2>(), limits.max_coordinate)) return false;
  if (!is_near(estimate.p_earth_node, limits.max_coordinate)) return false;
  if (!estimate.state.allFinite() || estimate.state.tail<2>().norm() > limits.max_speed) return false;
  return !estimate.covariance || is_covariance(*estimate.covariance);
}

}  // namespace lookout::fusion
