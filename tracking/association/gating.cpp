#include "tracking/association/gating.hpp"

#include <Eigen/LU>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::tracking {

double chi_square_gate(double probability, int dimensions) {
  if (!(probability > 0.0 && probability < 1.0))
    throw std::invalid_argument("gate probability must be in (0, 1), got " + std::to_string(probability));
  if (dimensions < 1)
    throw std::invalid_argument("gate dimensions must be >= 1, got " + std::to_string(dimensions));
  return boost::math::quantile(boost::math::chi_squared(dimensions), probability);
}

Eigen::Matrix2d position_noise(const core::Detection& detection, const core::SonarParams& sonar) {
  const double c = std::cos(detection.azimuth);
  const double s = std::sin(detection.azimuth);
  const double along = sonar.range_sigma * sonar.range_sigma;
  const double across = std::pow(detection.range * sonar.bearing_sigma_or_default(), 2);
  Eigen::Matrix2d noise;
  noise << along * c * c + across * s * s, (along - across) * c * s, (along - across) * c * s,
      along * s * s + across * c * c;
  return noise;
}

double squared_distance(const Eigen::Vector2d& difference, const Eigen::Matrix2d& covariance) {
  return difference.dot(covariance.inverse() * difference);
}

}  // namespace lookout::tracking
