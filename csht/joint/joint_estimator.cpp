#include "csht/joint/joint_estimator.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::csht {
namespace {

JointEstimatorParams for_sensor(JointEstimatorParams params, const core::SonarParams& sonar) {
  params.search.prior.max_speed = sonar.max_speed;
  params.model.clutter = clutter_model_of(sonar);
  if (params.window_scans < 3)
    throw std::invalid_argument("window_scans must be >= 3, got " + std::to_string(params.window_scans));
  if (!(params.min_existence >= 0.0 && params.min_existence <= 1.0))
    throw std::invalid_argument("min_existence must be in [0, 1], got " +
                                std::to_string(params.min_existence));
  if (params.first_estimate_scans < 1 || params.first_estimate_scans > params.window_scans)
    throw std::invalid_argument("first_estimate_scans must be 1 to window_scans, got " +
                                std::to_string(params.first_estimate_scans));
  if (!(params.prior_looks > 0.0 && params.memory_looks > 0.0))
    throw std::invalid_argument("prior_looks and memory_looks must be > 0, got " +
                                std::to_string(params.prior_looks) + " and " +
                                std::to_string(params.memory_looks));
  return params;
}

core::MotionElement element_of(const TargetHypothesis& target, std::int64_t initial_utime, double seconds) {
  core::MotionElement element;
  element.initial_utime = initial_utime;
  element.position = target.mean.head<2>();
  element.velocity = target.mean.tail<2>();
  element.initial_position = element.position + seconds * element.velocity;
  element.covariance = target.covariance;
  element.score = target.log_odds;
  element.existence = target.existence();
  element.support = static_cast<int>(std::lround(target.support));
  return element;
}

}  // namespace

JointEstimatorParams JointEstimatorParams::window() {
  JointEstimatorParams params;
  params.search.prior.interior_birth_rate = 0.0;
  params.search.prior.in_view_from_start = true;
  return params;
}

JointEstimator::JointEstimator(const JointEstimatorParams& params, const core::SonarParams& sonar,
                               std::uint64_t seed)
    : params_(for_sensor(params, sonar)),
      figures_(params_.figures, sonar),
      history_(figures_.figures(), params_.model, params_.window_scans),
      search_(params_.search),
      seed_(seed),
      random_(seed, core::RandomStream::estimator) {
  known_.reserve(static_cast<std::size_t>(params_.search.pool + params_.search.seeds.keep));
  elements_.reserve(static_cast<std::size_t>(params_.search.pool + params_.search.seeds.keep));
}

std::span<const core::MotionElement> JointEstimator::update(const core::PosedScan& scan) {
  history_.push(scan);
  random_.reseed(seed_, core::RandomStream::estimator, static_cast<std::uint64_t>(scan.scan.sequence));
  none_.clear(history_, params_.window_scans);
  const auto targets = search_.update(history_, params_.window_scans, none_, random_);
  report(targets);
  learn_figures(targets);
  learn_density(targets);
  return elements_;
}

// A gamma prior over the number of targets in view: its mean and weight, and what the looks so far have seen.
void JointEstimator::learn_density(std::span<const TargetHypothesis> targets) {
  if (history_.size() < params_.window_scans) return;
  const double look = 1.0 / params_.window_scans;
  const double kept = 1.0 - look / params_.memory_looks;
  looks_ = kept * looks_ + look;
  targets_seen_ *= kept;
  for (const auto& target : targets) targets_seen_ += look * target.existence();
  const double prior = params_.search.prior.targets_per_view;
  search_.set_targets_per_view((params_.prior_looks * prior + targets_seen_) /
                               (params_.prior_looks + looks_));
}

void JointEstimator::learn_figures(std::span<const TargetHypothesis> targets) {
  known_.clear();
  for (const auto& target : targets) known_.push_back({target.samples, target.existence()});
  figures_.update(history_, known_);
  history_.set_figures(figures_.figures());
}

void JointEstimator::report(std::span<const TargetHypothesis> targets) {
  const int oldest = history_.size() - 1;
  elements_.clear();
  if (history_.size() < params_.first_estimate_scans) return;
  for (const auto& target : targets)
    if (target.existence() > params_.min_existence)
      elements_.push_back(element_of(target, history_.at_age(oldest).utime, history_.seconds_at_age(oldest)));
}

}  // namespace lookout::csht
