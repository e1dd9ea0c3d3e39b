#pragma once

#include <Eigen/Core>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"

namespace lookout::tracking {

/// The chi-square quantile that holds a share `probability` of true measurements of `dimensions` numbers.
/// @throws std::invalid_argument unless 0 < probability < 1 and dimensions >= 1.
double chi_square_gate(double probability, int dimensions);

/// Covariance of a detection's earth-frame position [m^2]: range error along its azimuth, bearing error times
/// range across it.
Eigen::Matrix2d position_noise(const core::Detection& detection, const core::SonarParams& sonar);

/// Squared Mahalanobis length of a difference of positions [m] under its covariance [m^2].
double squared_distance(const Eigen::Vector2d& difference, const Eigen::Matrix2d& covariance);

}  // namespace lookout::tracking
