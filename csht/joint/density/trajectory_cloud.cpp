#include "csht/joint/density/trajectory_cloud.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "csht/likelihood/fast_math.hpp"
#include "csht/likelihood/vector_clones.hpp"

namespace lookout::csht {
namespace {

struct Arrays {
  const double *north, *east, *north_velocity, *east_velocity, *fifth, *sixth;
};

LOOKOUT_VECTOR_CLONES
void place_constant_acceleration(const Arrays& from, std::size_t size, double seconds, double* north,
                                 double* east) {
  const double half_square = 0.5 * seconds * seconds;
  for (std::size_t i = 0; i < size; ++i) {
    north[i] = from.north[i] + seconds * from.north_velocity[i] + half_square * from.fifth[i];
    east[i] = from.east[i] + seconds * from.east_velocity[i] + half_square * from.sixth[i];
  }
}

// Constant turn by the chord of its arc: at speed 1 it is 2 sin(h) / rate long and points h to the side of
// the velocity, h being half of the angle that is turned. [BarShalom2001] Sec. 11.7.
LOOKOUT_VECTOR_CLONES
void place_constant_turn(const Arrays& from, std::size_t size, double seconds, double* north, double* east) {
  // Slower turns are straight to within a millimetre; it keeps the quotient finite.
  constexpr double kLeastRate = 1e-7;
  for (std::size_t i = 0; i < size; ++i) {
    const double rate = from.fifth[i];
    const double divisor = rate < kLeastRate && rate > -kLeastRate ? kLeastRate : rate;
    const SinCos half = fast_sin_cos(0.5 * divisor * seconds);
    const double chord = 2.0 * half.sin / divisor;
    const double vn = from.north_velocity[i], ve = from.east_velocity[i];
    north[i] = from.north[i] + chord * (half.cos * vn - half.sin * ve);
    east[i] = from.east[i] + chord * (half.sin * vn + half.cos * ve);
  }
}

}  // namespace

double normalise_log_weights(std::span<const double> log_weight, std::span<double> weight) {
  const double largest = *std::max_element(log_weight.begin(), log_weight.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) sum += weight[i] = std::exp(log_weight[i] - largest);
  const double scale = 1.0 / sum;
  for (double& w : weight) w *= scale;
  return largest + std::log(sum);
}

void TrajectoryCloud::resize(std::size_t size) {
  for (auto* values : {&north, &east, &north_velocity, &east_velocity, &north_acceleration,
                       &east_acceleration, &turn_rate, &weight})
    values->resize(size);
}

void TrajectoryCloud::reserve(std::size_t size) {
  for (auto* values : {&north, &east, &north_velocity, &east_velocity, &north_acceleration,
                       &east_acceleration, &turn_rate, &weight})
    values->reserve(size);
}

Trajectory TrajectoryCloud::trajectory(std::size_t i) const {
  Trajectory result;
  result << north[i], east[i], north_velocity[i], east_velocity[i], 0.0, 0.0;
  if (motion == Motion::constant_turn) result[4] = turn_rate[i];
  if (motion == Motion::constant_acceleration)
    result.tail<2>() << north_acceleration[i], east_acceleration[i];
  return result;
}

std::array<double*, 6> TrajectoryCloud::components() {
  std::array<double*, 6> result{north.data(), east.data(), north_velocity.data(), east_velocity.data()};
  if (motion == Motion::constant_acceleration) {
    result[4] = north_acceleration.data();
    result[5] = east_acceleration.data();
  } else if (motion == Motion::constant_turn) {
    result[4] = turn_rate.data();
  }
  return result;
}

std::array<const double*, 6> TrajectoryCloud::components() const {
  const auto mine = const_cast<TrajectoryCloud*>(this)->components();
  std::array<const double*, 6> result;
  std::copy(mine.begin(), mine.end(), result.begin());
  return result;
}

void TrajectoryCloud::predict(double seconds) {
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector4d state = state_at(motion, trajectory(i), seconds);
    north[i] = state[0];
    east[i] = state[1];
    north_velocity[i] = state[2];
    east_velocity[i] = state[3];
  }
}

void TrajectoryCloud::place(double seconds, TrajectoryCloud& at) const {
  assert(motion != Motion::constant_velocity);  // The likelihood moves those by itself.
  at.resize(size());
  const Arrays from{north.data(),
                    east.data(),
                    north_velocity.data(),
                    east_velocity.data(),
                    motion == Motion::constant_turn ? turn_rate.data() : north_acceleration.data(),
                    east_acceleration.data()};
  if (motion == Motion::constant_turn)
    place_constant_turn(from, size(), seconds, at.north.data(), at.east.data());
  else
    place_constant_acceleration(from, size(), seconds, at.north.data(), at.east.data());
}

double TrajectoryCloud::reweigh(std::span<const double> log_ratio) {
  const double largest = *std::max_element(log_ratio.begin(), log_ratio.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) sum += weight[i] *= std::exp(log_ratio[i] - largest);
  const double scale = 1.0 / sum;
  for (double& w : weight) w *= scale;
  return largest + std::log(sum);
}

double TrajectoryCloud::effective_size() const {
  double squares = 0.0;
  for (const double w : weight) squares += w * w;
  return 1.0 / squares;
}

CloudMoments TrajectoryCloud::moments() const {
  CloudMoments result;
  result.motion = motion;
  const int d = dimensions(motion);
  const std::array<const double*, 6> component = components();
  for (int k = 0; k < d; ++k)
    for (std::size_t i = 0; i < size(); ++i)
      result.mean[k] += weight[i] * component[static_cast<std::size_t>(k)][i];
  for (std::size_t i = 0; i < size(); ++i) {
    double offset[6];
    for (int k = 0; k < d; ++k) offset[k] = component[static_cast<std::size_t>(k)][i] - result.mean[k];
    for (int k = 0; k < d; ++k)
      for (int l = 0; l <= k; ++l) result.covariance(k, l) += weight[i] * offset[k] * offset[l];
  }
  for (int k = 0; k < d; ++k)
    for (int l = 0; l < k; ++l) result.covariance(l, k) = result.covariance(k, l);
  return result;
}

}  // namespace lookout::csht
