#include "tracking/joint/standing.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace lookout::tracking {

double moving_probability(const csht::CloudMoments& moments, double velocity_sigma, double creep,
                          double standing_share) {
  const Eigen::Vector2d velocity = moments.mean.segment<2>(2);
  const Eigen::Matrix2d after =
      moments.covariance.block<2, 2>(2, 2) + creep * creep * Eigen::Matrix2d::Identity();
  const double before = velocity_sigma * velocity_sigma + creep * creep;
  // ln of the ratio of two normal densities at zero velocity; of the one before, the mean is zero.
  const double factor = -0.5 * velocity.dot(after.llt().solve(velocity)) -
                        0.5 * std::log(after.determinant()) + std::log(before);
  const double odds = std::log(standing_share / (1.0 - standing_share)) + factor;
  return 1.0 / (1.0 + std::exp(odds));
}

}  // namespace lookout::tracking
