#include "csht/joint/target_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "csht/joint/evidence/was_in_view.hpp"

namespace lookout::csht {
namespace {

// Squared Mahalanobis distance of position and velocity, with both covariances.
double state_distance(const CloudMoments& a, const CloudMoments& b) {
  const Eigen::Vector4d offset = a.mean.head<4>() - b.mean.head<4>();
  const Eigen::Matrix4d covariance = a.covariance.topLeftCorner<4, 4>() + b.covariance.topLeftCorner<4, 4>();
  return offset.dot(covariance.llt().solve(offset));
}

}  // namespace

TargetSearch::TargetSearch(const JointEngineParams& params)
    : params_(params.birth),
      hypotheses_(params.hypotheses),
      cloud_(params.cloud),
      seeds_(params.birth),
      claims_(params.claims) {
  found_.reserve(static_cast<std::size_t>(params.birth.seeds));
}

std::span<const int> TargetSearch::find(JointScene& scene) {
  prepare(scene);
  for (const BirthSeed& seed : seeds_.propose(scene.likelihood, scene.prior, scene.stopped)) {
    if (scene.stopped()) break;
    if (seed.log_odds > hypotheses_.tentative_log_odds - params_.hopeless && !known(seed, scene))
      begin(seed, scene);
  }
  return found_;
}

std::span<const int> TargetSearch::weigh(std::span<const BirthSeed> seeds, JointScene& scene) {
  prepare(scene);
  for (BirthSeed seed : seeds) {
    if (scene.stopped()) break;
    seed.window = window_of(seed.guess, scene.scans());
    if (!known(seed, scene)) begin(seed, scene);
  }
  return found_;
}

void TargetSearch::prepare(const JointScene& scene) {
  found_.clear();
  log_density_ = scene.prior.log_standing(scene.scans().newest());
}

// Age of the oldest scan that a target at `moments` is weighed over.
int TargetSearch::window_of(const CloudMoments& moments, const ScanHistory& scans) const {
  const Eigen::Vector4d trajectory = moments.mean.head<4>();
  const double background = background_along(trajectory, scans, birth_window(scans, params_));
  return birth_window(scans, params_, background);
}

// Whether a hypothesis stands for the seed already. A tentative one that is much less probable is released.
bool TargetSearch::known(const BirthSeed& seed, JointScene& scene) const {
  for (TargetTrack& track : scene.tracks) {
    if (!track.used) continue;
    if ((track.moments.mean.head<2>() - seed.guess.mean.head<2>()).norm() > params_.track_reach) continue;
    if (state_distance(track.moments, seed.guess) > params_.same_target) continue;
    if (track.confirmed_once || seed.log_odds < track.log_odds + params_.better_nats) return true;
    scene.release(track);
  }
  return false;
}

// Draws the density of a seed to `fresh`. @return whether it is worth a hypothesis.
bool TargetSearch::draw(const BirthSeed& seed, double& log_odds, JointScene& scene) const {
  const double least = hypotheses_.tentative_log_odds - log_density_;
  SamplingTask task;
  task.guess = seed.guess;
  task.ages = {0, seed.window, true};
  task.samples = params_.samples;
  task.rounds = params_.rounds;
  task.give_up_below = least - params_.hopeless;
  if (scene.sampler.sample(task, scene.likelihood, scene.random, scene.fresh).log_evidence <
      least - params_.doubtful)
    return false;
  // The seed was chosen because this estimate was high, so the estimate is too high on average. The odds come
  // from a second one, by new draws, which played no part in the choice.
  task.guess = scene.fresh.moments();
  task.samples = cloud_.trajectories;
  const SamplingResult result = scene.sampler.sample(task, scene.likelihood, scene.random, scene.fresh);
  log_odds = result.log_evidence + log_density_;
  return log_odds >= hypotheses_.tentative_log_odds && result.effective_share >= cloud_.trusted_share &&
         was_in_view(scene.fresh.moments(), scene.scans(), seed.window);
}

void TargetSearch::begin(const BirthSeed& seed, JointScene& scene) {
  double log_odds = 0.0;
  if (!draw(seed, log_odds, scene)) return;
  TargetTrack* const track = scene.free_track();
  if (track == nullptr) return;
  const ScanHistory& scans = scene.scans();
  std::swap(track->cloud, scene.fresh);
  track->begin({.log_odds = std::min(log_odds, hypotheses_.settled_log_odds),
                .log_density = log_density_,
                .first_scan = scans.pushed() - 1 - seed.window,
                .first_utime = scans.at_age(seed.start_age).utime,
                .utime = scene.now()});
  claim(*track, scene);
  found_.push_back(scene.slot_of(*track));
}

void TargetSearch::claim(TargetTrack& track, JointScene& scene) {
  const MemorySpan memory{.constant_velocity_s = cloud_.memory_s};
  claims_.claim_memory(scene.slot_of(track), track, memory_of(track, scene.scans(), memory),
                       scene.likelihood);
}

bool TargetSearch::update(TargetTrack& track, JointScene& scene) const {
  track.log_ratio.assign(track.cloud.size(), 0.0);
  scene.likelihood.add(track.cloud, track.moments.mean, {0, 0}, scene.slot_of(track), track.log_ratio);
  const double evidence = track.cloud.reweigh(track.log_ratio);
  track.log_odds += evidence;
  track.recent.add(evidence, evidence);
  track.moments = track.cloud.moments();
  return track.cloud.effective_size() >= cloud_.refresh_share * static_cast<double>(track.cloud.size());
}

void TargetSearch::revise(TargetTrack& track, JointScene& scene) {
  prepare(scene);
  SamplingTask task;
  task.guess = track.moments;
  task.ages = {0, window_of(track.moments, scene.scans()), true};
  task.self = scene.slot_of(track);
  task.samples = cloud_.trajectories;
  task.rounds = params_.rounds;
  const SamplingResult result = scene.sampler.sample(task, scene.likelihood, scene.random, scene.fresh);
  std::swap(track.cloud, scene.fresh);
  track.moments = track.cloud.moments();
  track.log_odds = std::min(result.log_evidence + log_density_, hypotheses_.settled_log_odds);
  track.first_scan = scene.scans().pushed() - 1 - task.ages.oldest;
  track.claims_are_fresh = false;
  claim(track, scene);
}

BirthSeed seed_of(const core::MotionElement& element, const ScanHistory& scans) {
  BirthSeed seed;
  seed.guess.mean.head<4>() = element.state();
  seed.guess.covariance.topLeftCorner<4, 4>() = element.covariance;
  for (int age = 0; age < scans.size() && scans.at_age(age).utime >= element.initial_utime; ++age)
    seed.start_age = age;
  return seed;
}

}  // namespace lookout::csht
