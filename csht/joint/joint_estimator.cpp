#include "csht/joint/joint_estimator.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"
#include "csht/joint/density/sensor_scale.hpp"

namespace lookout::csht {
namespace {

constexpr double kWholeWindow = 1e9;  // [nats] and [s]: more than any window holds.
constexpr double kInViewShare = 0.5;  // Visible share below which a target has left.

// Whether `other` lies within a squared Mahalanobis distance of `surer`, by the covariance of the latter.
bool one_target(const CloudMoments& surer, const CloudMoments& other, double distance) {
  const Eigen::Vector4d offset = other.mean.head<4>() - surer.mean.head<4>();
  return offset.dot(surer.covariance.topLeftCorner<4, 4>().llt().solve(offset)) <= distance;
}

const JointEstimatorParams& validated(const JointEstimatorParams& params) {
  validate(params.engine);
  validate(params.alone);
  core::require(params.window_scans >= 3, "window_scans must be >= 3", params.window_scans);
  core::require(params.min_existence >= 0.0 && params.min_existence <= 1.0, "min_existence must be in [0, 1]",
                params.min_existence);
  core::require(params.first_estimate_scans >= 1 && params.first_estimate_scans <= params.window_scans,
                "first_estimate_scans must be 1 to window_scans", params.first_estimate_scans);
  core::require(params.merge_distance > 0.0, "merge_distance must be > 0", params.merge_distance);
  core::require(params.prior_looks > 0.0, "prior_looks must be > 0", params.prior_looks);
  core::require(params.memory_looks > 0.0, "memory_looks must be > 0", params.memory_looks);
  return params;
}

JointEngineParams for_window(const JointEstimatorParams& params, const core::SonarParams& sonar) {
  JointEngineParams engine = scaled(params.alone, SensorScale::of(sonar));
  engine.scans_kept = params.window_scans;
  engine.learning.least_existence = params.min_existence;
  return engine;
}

}  // namespace

JointEngineParams window_engine() {
  JointEngineParams engine;
  BirthParams& birth = engine.birth;
  birth.enough_nats = birth.window_s = birth.first_look_s = birth.max_lag_s = kWholeWindow;
  birth.seed_tolerance.sigma_scale = 1.4;
  birth.refine_rounds = 4;
  birth.seeds = 100;
  birth.hopeless = 6.0;
  engine.hypotheses.tentative_log_odds = -8.0;
  engine.hypotheses.settled_log_odds = 20.0;  // A cap alone: all odds come from the whole window.
  engine.cloud.trusted_share = 0.02;
  engine.prior.uniform_speeds = true;
  engine.clutter.map.enabled = false;  // A single window is too short to learn from.
  return engine;
}

JointEstimatorParams JointEstimatorParams::window() {
  JointEstimatorParams params;
  params.alone.prior.interior_rate = 0.0;
  params.alone.prior.settling_rate = 0.0;
  params.alone.prior.in_view_from_start = true;
  return params;
}

JointEstimator::JointEstimator(const JointEstimatorParams& params, const core::SonarParams& sonar,
                               std::uint64_t seed)
    : params_(validated(params)),
      sonar_(sonar),
      seed_(seed),
      search_(scaled(params.engine, SensorScale::of(sonar))) {}

std::span<const core::MotionElement> JointEstimator::update(const core::PosedScan& scan) {
  elements_.clear();
  if (offered_ != nullptr)
    find_beyond(*offered_);
  else
    estimate_alone(scan);
  return elements_;
}

std::optional<core::SensorEstimate> JointEstimator::sensor_estimate() const {
  if (offered_ != nullptr) return offered_->learning().estimate();
  if (!own_) return std::nullopt;
  return own_->scene.learning().estimate();
}

void JointEstimator::find_beyond(JointScene& scene) {
  report(search_.find(scene), 0.0, scene);
}

void JointEstimator::estimate_alone(const core::PosedScan& scan) {
  if (!own_) {
    const JointEngineParams engine = for_window(params_, sonar_);
    own_.emplace(
        Own{JointScene(engine, sonar_, {seed_, core::RandomStream::estimator}), TargetSearch(engine)});
  }
  const double seconds = own_->scene.take(scan);
  for (TargetTrack& track : own_->scene.tracks)
    if (track.used) track.advance(seconds);
  revise_hypotheses();
  own_->search.find(own_->scene);
  let_targets_claim();
  drop_hopeless();
  own_->scene.learn();
  learn_density();
  if (own_->scene.scans().size() >= params_.first_estimate_scans)
    report(order_, params_.min_existence, own_->scene);
}

// Fills `order_` with the slots of all hypotheses, the most probable first.
void JointEstimator::order_by_odds() {
  order_.clear();
  const auto& tracks = own_->scene.tracks;
  for (const TargetTrack& track : tracks)
    if (track.used) order_.push_back(own_->scene.slot_of(track));
  std::sort(order_.begin(), order_.end(), [&tracks](int a, int b) {
    return tracks[static_cast<std::size_t>(a)].log_odds > tracks[static_cast<std::size_t>(b)].log_odds;
  });
}

// Of two hypotheses on one target the more probable stays: both would share its detections, and neither have
// enough.
void JointEstimator::merge_twins() {
  order_by_odds();
  auto& tracks = own_->scene.tracks;
  for (std::size_t k = 1; k < order_.size(); ++k) {
    TargetTrack& doubtful = tracks[static_cast<std::size_t>(order_[k])];
    const auto is_twin = [&](int slot) {
      const TargetTrack& surer = tracks[static_cast<std::size_t>(slot)];
      return surer.used && one_target(surer.moments, doubtful.moments, params_.merge_distance);
    };
    if (std::any_of(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(k), is_twin))
      own_->scene.release(doubtful);
  }
  std::erase_if(order_, [&tracks](int slot) { return !tracks[static_cast<std::size_t>(slot)].used; });
}

// The most probable first: their detections are claimed before less probable ones are weighed.
void JointEstimator::revise_hypotheses() {
  merge_twins();
  for (const int slot : order_) {
    TargetTrack& track = own_->scene.tracks[static_cast<std::size_t>(slot)];
    // For a doubtful hypothesis the newest scan's update is enough, as long as its cloud is sound.
    const bool sound = own_->search.update(track, own_->scene);
    if (!sound || track.log_odds > params_.revise_above) own_->search.revise(track, own_->scene);
    let_targets_claim();
  }
}

// Only what is more likely a target than not claims detections: if many doubtful hypotheses shared them, none
// would be left with enough.
void JointEstimator::let_targets_claim() {
  for (const TargetTrack& track : own_->scene.tracks)
    if (track.used && track.existence() < params_.min_existence)
      own_->scene.likelihood.set_existence(own_->scene.slot_of(track), 0.0);
}

// Frees hypotheses that are too improbable; `order_` keeps those of the rest that are in view.
void JointEstimator::drop_hopeless() {
  merge_twins();
  order_.clear();
  for (TargetTrack& track : own_->scene.tracks) {
    if (!track.used) continue;
    if (track.log_odds < params_.alone.hypotheses.tentative_log_odds)
      own_->scene.release(track);
    else if (track.visible_share >= kInViewShare)
      order_.push_back(own_->scene.slot_of(track));
  }
}

// The number of targets in view is Poisson with a gamma prior, of which `prior_looks` is the weight; its
// posterior mean is the prior's mean and the numbers seen so far, one a window, averaged by their weights.
void JointEstimator::learn_density() {
  if (own_->scene.scans().size() < params_.window_scans) return;
  const double look = 1.0 / params_.window_scans;
  const double kept = 1.0 - look / params_.memory_looks;
  looks_ = kept * looks_ + look;
  targets_seen_ *= kept;
  for (const int slot : order_) {
    const TargetTrack& track = own_->scene.tracks[static_cast<std::size_t>(slot)];
    if (track.existence() > params_.min_existence) targets_seen_ += look * track.existence();
  }
  const double prior = params_.alone.prior.expected_targets;
  own_->scene.set_expected_targets((params_.prior_looks * prior + targets_seen_) /
                                   (params_.prior_looks + looks_));
}

void JointEstimator::report(std::span<const int> slots, double least_existence, const JointScene& scene) {
  for (const int slot : slots) {
    const TargetTrack& target = scene.tracks[static_cast<std::size_t>(slot)];
    if (target.existence() > least_existence) elements_.push_back(element_of(target, scene));
  }
}

core::MotionElement JointEstimator::element_of(const TargetTrack& target, const JointScene& scene) const {
  const ScanHistory& scans = scene.scans();
  const int oldest = std::min(params_.window_scans, scans.size()) - 1;
  core::MotionElement element;
  element.initial_utime = scans.at_age(oldest).utime;
  element.position = target.moments.mean.head<2>();
  element.velocity = target.moments.mean.segment<2>(2);
  element.initial_position = element.position + scans.seconds_at_age(oldest) * element.velocity;
  element.covariance = target.moments.covariance.topLeftCorner<4, 4>();
  element.score = target.log_odds;
  element.existence = target.existence();
  element.support = static_cast<int>(std::lround(target.own_detections));
  element.hypothesis = scene.slot_of(target);
  return element;
}

}  // namespace lookout::csht
