#include "tracking/association/gating.hpp"

#include <Eigen/LU>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

double chi_square_gate(double probability, int dimensions) {
  core::require_inner_share("gate probability", probability);
  core::require(dimensions >= 1, "gate dimensions must be >= 1", dimensions);
  return boost::math::quantile(boost::math::chi_squared(dimensions), probability);
}

Eigen::Matrix2d position_noise(const core::Detection& detection, const core::SonarParams& sonar) {
  const double c = std::cos(detection.azimuth);
  const double s = std::sin(detection.azimuth);
  const double along = sonar.range_sigma * sonar.range_sigma;
  const double across = std::pow(detection.range * sonar.bearing_sigma_at(detection.beam), 2);
  Eigen::Matrix2d noise;
  noise << along * c * c + across * s * s, (along - across) * c * s, (along - across) * c * s,
      along * s * s + across * c * c;
  return noise;
}

double squared_distance(const Eigen::Vector2d& difference, const Eigen::Matrix2d& covariance) {
  return difference.dot(covariance.inverse() * difference);
}

}  // namespace lookout::tracking
