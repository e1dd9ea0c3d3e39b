#include "tracking/track_before_detect/frames/h_pmht_target.hpp"

#include <Eigen/LU>

#include "core/constant_velocity.hpp"

namespace lookout::tracking {

HPmhtTarget::HPmhtTarget(const HPmhtParams& params, std::int64_t id, const Eigen::Vector4d& state,
                         const Eigen::Matrix4d& covariance, double weight)
    : params_(params), id_(id), start_covariance_(covariance), epochs_(1) {
  epochs_[0].smoothed = epochs_[0].filtered = state;
  epochs_[0].variance.setConstant(params.initial_variance());
  epochs_[0].weight = weight;
}

void HPmhtTarget::start_batch(std::span<const double> steps) {
  epochs_.resize(steps.size() + 1);
  for (std::size_t t = 1; t < epochs_.size(); ++t) {
    epochs_[t] = epochs_[t - 1];
    epochs_[t].smoothed = core::constant_velocity_transition(steps[t - 1]) * epochs_[t - 1].smoothed;
  }
}

CellModel HPmhtTarget::model(std::size_t t) const {
  return {epochs_[t].smoothed.head<2>(), epochs_[t].variance, epochs_[t].weight};
}

void HPmhtTarget::take(std::size_t t, const Expectation& expectation, const TargetSums& sums,
                       double noise_scale) {
  Epoch& epoch = epochs_[t];
  epoch.sums = sums;
  SyntheticMeasurement& measurement = epoch.measurement;
  const double intensity = epoch.weight * sums.responsibility;
  measurement.noise_scale = noise_scale;
  measurement.valid = !lost_ && intensity > 0.0 && expectation.total_intensity > 0.0;
  if (!measurement.valid) return;
  measurement.position = epoch.smoothed.head<2>() + sums.first / sums.responsibility;  // Eq. (12)
  measurement.variance = epoch.variance / intensity;                                   // Eq. (13)
}

void HPmhtTarget::maximise(std::span<const double> steps) {
  std::vector<Eigen::Vector2d> old_means(epochs_.size());
  for (std::size_t t = 1; t < epochs_.size(); ++t) old_means[t] = epochs_[t].smoothed.head<2>();
  epochs_[0].filtered = epochs_[0].smoothed;
  // P_0 in the scaled units of the first frame, so that only true ratios R : Q : P_0 matter.
  epochs_[0].covariance = start_covariance_ * epochs_[1].measurement.noise_scale;
  const Eigen::Vector4d start = epochs_[0].smoothed;
  for (std::size_t t = 1; t < epochs_.size(); ++t) filter(epochs_[t - 1], epochs_[t], steps[t - 1]);
  epochs_.back().smoothed = epochs_.back().filtered;
  for (std::size_t t = epochs_.size() - 1; t-- > 0;) smooth(epochs_[t], epochs_[t + 1], steps[t]);
  if (params_.learn_variance)
    for (std::size_t t = 1; t < epochs_.size(); ++t) learn_variance(epochs_[t], old_means[t]);
  if (params_.process_noise == ProcessNoise::printed) learn_process_noise(steps);
  epochs_[0].smoothed = start;  // the next iteration starts from what is known, not from its own smoothing
}

void HPmhtTarget::filter(const Epoch& before, Epoch& epoch, double step) const {
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const SyntheticMeasurement& measurement = epoch.measurement;
  epoch.predicted = F * before.covariance * F.transpose() + measurement.noise_scale * process_noise(step);
  epoch.filtered = F * before.filtered;
  epoch.covariance = epoch.predicted;
  if (!measurement.valid) return;
  Eigen::Matrix2d innovation_covariance = epoch.predicted.topLeftCorner<2, 2>();
  innovation_covariance.diagonal() += measurement.variance;
  const Eigen::Matrix<double, 4, 2> gain =
      epoch.predicted.leftCols<2>() * innovation_covariance.inverse();         // Eq. (17)
  epoch.filtered += gain * (measurement.position - epoch.filtered.head<2>());  // Eq. (19)
  epoch.covariance -= gain * epoch.predicted.topRows<2>();                     // Eq. (18)
  epoch.covariance = (0.5 * (epoch.covariance + epoch.covariance.transpose())).eval();
}

void HPmhtTarget::smooth(Epoch& epoch, const Epoch& after, double step) const {
  const Eigen::Matrix4d F = core::constant_velocity_transition(step);
  const Eigen::FullPivLU<Eigen::Matrix4d> predicted(after.predicted);
  epoch.smoothed = epoch.filtered;
  if (!predicted.isInvertible()) return;  // a printed Q of rank one: nothing to carry back
  epoch.smoothed +=
      epoch.covariance * F.transpose() * predicted.solve(after.smoothed - F * epoch.filtered);  // Eq. (20)
}

void HPmhtTarget::learn_variance(Epoch& epoch, const Eigen::Vector2d& old_mean) const {
  if (!epoch.measurement.valid) return;
  const Eigen::Array2d shift = old_mean - epoch.smoothed.head<2>();
  const Eigen::Array2d second = epoch.sums.second.array() + 2.0 * shift * epoch.sums.first.array() +
                                shift.square() * epoch.sums.responsibility;
  epoch.variance = (second / epoch.sums.responsibility)  // Eq. (22)
                       .max(params_.min_variance)
                       .min(params_.variance_limit());
}

void HPmhtTarget::learn_process_noise(std::span<const double> steps) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  double weights = 0.0;
  for (std::size_t t = 1; t < epochs_.size(); ++t) {
    const double weight = 1.0 / epochs_[t].measurement.noise_scale;
    const Eigen::Vector4d error =
        epochs_[t].smoothed - core::constant_velocity_transition(steps[t - 1]) * epochs_[t - 1].smoothed;
    sum += weight * error * error.transpose();
    weights += weight;
  }
  printed_noise_ = sum / weights;  // Eq. (23)
}

Eigen::Matrix4d HPmhtTarget::process_noise(double step) const {
  return printed_noise_ ? *printed_noise_ : core::white_acceleration_noise(step, params_.noise_density);
}

void HPmhtTarget::end_batch() {
  const Epoch last = epochs_.back();
  start_covariance_ = last.covariance / last.measurement.noise_scale;
  epochs_.resize(1);
  epochs_[0] = last;
}

FrameTrack HPmhtTarget::track(std::size_t t) const {
  const Epoch& epoch = epochs_[t];
  FrameTrack track;
  track.id = id_;
  track.state = epoch.smoothed;
  track.covariance = epoch.covariance / epoch.measurement.noise_scale;
  track.intensity = epoch.weight * epoch.sums.responsibility;
  track.lost = lost_;
  return track;
}

}  // namespace lookout::tracking
