#include "tracking/joint_cloud.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {

double normalise_log_weights(std::span<const double> log_weight, std::span<double> weight) {
  const double largest = *std::max_element(log_weight.begin(), log_weight.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) sum += weight[i] = std::exp(log_weight[i] - largest);
  const double scale = 1.0 / sum;
  for (double& w : weight) w *= scale;
  return largest + std::log(sum);
}

void JointCloud::resize(std::size_t size) {
  for (auto* values :
       {&north, &east, &north_velocity, &east_velocity, &north_acceleration, &east_acceleration, &weight})
    values->resize(size);
}

void JointCloud::reserve(std::size_t size) {
  for (auto* values :
       {&north, &east, &north_velocity, &east_velocity, &north_acceleration, &east_acceleration, &weight})
    values->reserve(size);
}

void JointCloud::predict(double seconds) {
  const double half_square = 0.5 * seconds * seconds;
  for (std::size_t i = 0; i < size(); ++i) {
    north[i] += north_velocity[i] * seconds + north_acceleration[i] * half_square;
    east[i] += east_velocity[i] * seconds + east_acceleration[i] * half_square;
    north_velocity[i] += north_acceleration[i] * seconds;
    east_velocity[i] += east_acceleration[i] * seconds;
  }
}

double JointCloud::reweigh(std::span<const double> log_ratio) {
  const double largest = *std::max_element(log_ratio.begin(), log_ratio.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) sum += weight[i] *= std::exp(log_ratio[i] - largest);
  const double scale = 1.0 / sum;
  for (double& w : weight) w *= scale;
  return largest + std::log(sum);
}

double JointCloud::effective_size() const {
  double squares = 0.0;
  for (const double w : weight) squares += w * w;
  return 1.0 / squares;
}

CloudMoments JointCloud::moments() const {
  CloudMoments result;
  const int d = dimensions();
  const double* component[] = {north.data(),
                               east.data(),
                               north_velocity.data(),
                               east_velocity.data(),
                               north_acceleration.data(),
                               east_acceleration.data()};
  for (int k = 0; k < d; ++k)
    for (std::size_t i = 0; i < size(); ++i) result.mean[k] += weight[i] * component[k][i];
  for (std::size_t i = 0; i < size(); ++i) {
    double offset[6];
    for (int k = 0; k < d; ++k) offset[k] = component[k][i] - result.mean[k];
    for (int k = 0; k < d; ++k)
      for (int l = 0; l <= k; ++l) result.covariance(k, l) += weight[i] * offset[k] * offset[l];
  }
  for (int k = 0; k < d; ++k)
    for (int l = 0; l < k; ++l) result.covariance(l, k) = result.covariance(k, l);
  return result;
}

}  // namespace lookout::tracking
