#include "tracking/baselines/gaussian/gaussian_target.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kLeastWeight = 1e-12;  // Least weight of a model of motion: with 0 it could never come back.

/// What one mode expects of a measurement.
struct Innovation {
  Eigen::Vector2d residual;
  Eigen::Matrix2d inverse;  // Of the residual's covariance.
  double determinant = 1.0;

  double squared() const { return residual.dot(inverse * residual); }
  double density() const {
    return std::exp(-0.5 * squared()) / (2.0 * std::numbers::pi * std::sqrt(determinant));
  }
};

Innovation innovation_of(const GaussianMode& mode, const PositionMeasurement& measurement) {
  const Eigen::Matrix2d covariance = mode.covariance.topLeftCorner<2, 2>() + measurement.noise;
  return {measurement.position - mode.mean.head<2>(), covariance.inverse(), covariance.determinant()};
}

void update(GaussianMode& mode, const Innovation& innovation, const Eigen::Matrix2d& noise) {
  const Eigen::Matrix<double, 4, 2> gain = mode.covariance.leftCols<2>() * innovation.inverse;
  Eigen::Matrix4d left = Eigen::Matrix4d::Identity();
  left.leftCols<2>() -= gain;
  mode.mean += gain * innovation.residual;
  // Joseph's form stays symmetric and positive.
  mode.covariance = left * mode.covariance * left.transpose() + gain * noise * gain.transpose();
}

}  // namespace

Eigen::Vector4d GaussianTarget::mean() const {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const auto& mode : used()) sum += mode.weight * mode.mean;
  return sum;
}

Eigen::Matrix4d GaussianTarget::covariance() const {
  const Eigen::Vector4d centre = mean();
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const auto& mode : used()) {
    const Eigen::Vector4d offset = mode.mean - centre;
    sum += mode.weight * (mode.covariance + offset * offset.transpose());
  }
  return sum;
}

double density(const GaussianTarget& target, const PositionMeasurement& measurement) {
  double sum = 0.0;
  for (const auto& mode : target.used()) sum += mode.weight * innovation_of(mode, measurement).density();
  return sum;
}

double squared_distance(const GaussianTarget& target, const PositionMeasurement& measurement) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& mode : target.used()) least = std::min(least, innovation_of(mode, measurement).squared());
  return least;
}

GaussianTarget updated(const GaussianTarget& target, const PositionMeasurement& measurement) {
  GaussianTarget result = target;
  double total = 0.0;
  for (auto& mode : result.used()) {
    const Innovation innovation = innovation_of(mode, measurement);
    update(mode, innovation, measurement.noise);
    mode.weight = std::max(kLeastWeight, mode.weight * innovation.density());
    total += mode.weight;
  }
  for (auto& mode : result.used()) mode.weight /= total;
  return result;
}

}  // namespace lookout::tracking
