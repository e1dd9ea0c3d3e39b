#include "csht/joint/sensor_learning.hpp"

#include <algorithm>
#include <cmath>

#include "csht/joint/density/wander.hpp"

namespace lookout::csht {

void resample(const TrajectoryCloud& cloud, int count, std::vector<Eigen::Vector4d>& samples) {
  samples.clear();
  const auto wanted = static_cast<std::size_t>(count);
  const double step = 1.0 / static_cast<double>(count);
  double next = 0.5 * step;
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (sum += cloud.weight[i]; next < sum && samples.size() < wanted; next += step)
      samples.emplace_back(cloud.north[i], cloud.east[i], cloud.north_velocity[i], cloud.east_velocity[i]);
}

namespace {

// Of targets that stray a trajectory holds for a while only: after half its memory a scan is settled.
SensorFigureParams figure_params(const core::SonarParams& sonar) {
  SensorFigureParams params;
  const double memory = Wander(sonar).memory(figures_of(sonar), 0.0);
  if (std::isfinite(memory))
    params.settle_scans =
        std::clamp(static_cast<int>(0.5 * memory / sonar.scan_period), 1, params.settle_scans);
  return params;
}

}  // namespace

SensorLearning::SensorLearning(const SensorLearningParams& params, const core::SonarParams& sonar)
    : params_(params),
      max_speed_(sonar.max_speed),
      targets_stray_(Wander(sonar).active()),
      given_(figures_of(sonar)),
      figures_(figure_params(sonar), sonar),
      used_(figures_.figures()) {}

void SensorLearning::weigh_errors(const TrajectoryCloud& predicted, const BeamMask* mask,
                                  const ScanTable& newest) {
  if (targets_stray_) errors_.take(predicted, newest, mask, used_.range_sigma / given_.range_sigma);
}

void SensorLearning::choose_figures() {
  used_ = figures_.figures();
  if (!targets_stray_) return;
  used_.range_sigma = errors_.factor() * given_.range_sigma;
  used_.bearing_sigma = errors_.factor() * given_.bearing_sigma;
}

void SensorLearning::learn(std::span<const TargetTrack> tracks, ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  targets_.clear();
  for (const TargetTrack& track : tracks) {
    if (!track.used || track.cloud.motion == Motion::constant_acceleration ||
        track.existence() < params_.least_existence || !moves(track))
      continue;
    if (samples_.size() == targets_.size())
      samples_.emplace_back().reserve(static_cast<std::size_t>(params_.target_samples));
    auto& samples = samples_[targets_.size()];
    resample(track.cloud, params_.target_samples, samples);
    const auto since_first = static_cast<int>(scans.pushed() - 1 - track.first_scan);
    targets_.push_back({samples, track.existence(), std::min(since_first, track.recent.size())});
  }
  figures_.update(scans, targets_);
  choose_figures();
  if (changed(scans.figures())) likelihood.set_figures(used_);
}

bool SensorLearning::moves(const TargetTrack& track) const {
  return track.moments.mean.segment<2>(2).norm() > params_.least_speed * max_speed_ ||
         surely_moves(track.moments, params_.mover, max_speed_);
}

bool SensorLearning::changed(const SensorFigures& before) const {
  const SensorFigures& now = used_;
  const auto differ = [this](double a, double b) {
    return std::abs(a - b) > params_.least_change * std::min(a, b);
  };
  if (std::abs(now.range_loss - before.range_loss) > params_.least_change ||
      std::abs(now.tail_share - before.tail_share) > params_.least_change)
    return true;
  return differ(now.miss_probability, before.miss_probability) ||
         differ(now.false_alarm_probability, before.false_alarm_probability) ||
         differ(now.clutter_per_scan, before.clutter_per_scan) || differ(now.range_sigma, before.range_sigma);
}

}  // namespace lookout::csht
