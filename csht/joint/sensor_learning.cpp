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

constexpr double kSure = 0.9;  // Probability that targets stray from which on they do.

// Of targets that stray a trajectory holds for a while only: after half its memory a scan is settled.
int settle_scans(const core::SonarParams& sonar, const Wander& wander) {
  const int rigid = SensorFigureParams{}.settle_scans;
  const double memory = wander.memory(figures_of(sonar), 0.0);
  if (!std::isfinite(memory)) return rigid;
  return std::clamp(static_cast<int>(0.5 * memory / sonar.scan_period), 1, rigid);
}

}  // namespace

SensorLearning::SensorLearning(const SensorLearningParams& params, const core::SonarParams& sonar)
    : params_(params),
      max_speed_(sonar.max_speed),
      sonar_(sonar),
      wander_(sonar),
      straying_(sonar),
      given_(figures_of(sonar)),
      figures_({}, sonar),
      used_(figures_.figures()) {
  figures_.set_settle_scans(settle_scans(sonar_, wander_));
}

void SensorLearning::weigh_errors(const TargetTrack& predicted, const BeamMask* mask,
                                  const ScanTable& newest) {
  if (moves(predicted)) straying_.take(predicted, newest, mask);
}

void SensorLearning::choose_wander() {
  if (sonar_.wander) return;
  const WanderEstimate estimate = straying_.estimate();
  wander_ = Wander(sonar_, estimate.probability > kSure ? estimate.rate : 0.0);
  figures_.set_settle_scans(settle_scans(sonar_, wander_));
}

void SensorLearning::choose_figures() {
  used_ = figures_.figures();
  if (!wander_.active()) return;
  const double factor = straying_.estimate().error_factor;
  used_.range_sigma = factor * given_.range_sigma;
  used_.bearing_sigma = factor * given_.bearing_sigma;
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
  choose_wander();
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
