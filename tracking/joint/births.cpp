#include "tracking/joint/births.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "tracking/joint/proposed_seed.hpp"

namespace lookout::tracking {
namespace {

// Squared Mahalanobis distance of position and velocity, with both covariances.
double state_distance(const csht::CloudMoments& a, const csht::CloudMoments& b) {
  const Eigen::Vector4d offset = a.mean.head<4>() - b.mean.head<4>();
  const Eigen::Matrix4d covariance = a.covariance.topLeftCorner<4, 4>() + b.covariance.topLeftCorner<4, 4>();
  return offset.dot(covariance.llt().solve(offset));
}

}  // namespace

Births::Births(const JointTrackerParams& params, const csht::TargetPrior& prior,
               std::unique_ptr<BirthMethod> births)
    : params_(params.birth),
      life_(params.life),
      cloud_(params.cloud),
      memory_{params.cloud.memory_s, params.manoeuvre.memory_s, params.manoeuvre.least_scans},
      prior_(prior),
      birth_(params.birth, prior),
      births_(std::move(births)),
      observer_(params.observer) {}

void Births::begin(const core::PosedScan& scan, TrackerState& state) {
  log_density_ = prior_.log_standing(state.scans().newest());
  window_ = {0, csht::birth_window(state.scans(), params_), true};
  if (births_ != nullptr)
    begin_on_proposals(scan, state);
  else
    begin_on_pairs(state);
}

void Births::begin_on_pairs(TrackerState& state) {
  for (const csht::BirthSeed& seed : birth_.propose(state.likelihood))
    if (seed.log_odds > life_.tentative_log_odds - params_.hopeless && !known(seed, state))
      begin_track(seed, state);
}

void Births::begin_on_proposals(const core::PosedScan& scan, TrackerState& state) {
  living_.clear();
  for (const csht::TargetTrack& track : state.tracks) {
    if (!track.used || track.existence() < csht::ScanLikelihood::kLeastExistence) continue;
    core::Track& living = living_.emplace_back();
    living.state = track.moments.mean.head<4>();
    living.covariance = track.moments.covariance.topLeftCorner<4, 4>();
  }
  for (const core::MotionElement& element : births_->propose(scan, living_)) {
    const csht::BirthSeed seed = seed_of(element, state.scans());
    if (!known(seed, state)) begin_track(seed, state);
  }
}

// Whether a track stands for the seed already. A tentative one that is much less probable gives way.
bool Births::known(const csht::BirthSeed& seed, TrackerState& state) const {
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    if ((track.moments.mean.head<2>() - seed.guess.mean.head<2>()).norm() > params_.track_reach) continue;
    if (state_distance(track.moments, seed.guess) > params_.same_target) continue;
    if (track.confirmed_once || seed.log_odds < track.log_odds + params_.better_nats) return true;
    state.end(track, DecisionKind::merge, "a better candidate takes its place");
  }
  return false;
}

// Draws the density of a seed to `fresh`. @return whether it is worth a track.
bool Births::draw(const csht::BirthSeed& seed, double& log_odds, TrackerState& state) const {
  const double least = life_.tentative_log_odds - log_density_;
  csht::SamplingTask task;
  task.guess = seed.guess;
  task.ages = window_;
  task.samples = params_.samples;
  task.rounds = params_.rounds;
  task.give_up_below = least - params_.hopeless;
  if (state.sampler.sample(task, state.likelihood, state.random, state.fresh).log_evidence <
      least - params_.doubtful)
    return false;
  // Of many seeds the luckiest estimates stand out: once more, with trajectories that nothing was chosen by.
  task.guess = state.fresh.moments();
  task.samples = cloud_.trajectories;
  const csht::SamplingResult result = state.sampler.sample(task, state.likelihood, state.random, state.fresh);
  log_odds = result.log_evidence + log_density_;
  return log_odds >= life_.tentative_log_odds && result.effective_share >= cloud_.trusted_share;
}

void Births::begin_track(const csht::BirthSeed& seed, TrackerState& state) {
  double log_odds = 0.0;
  if (!draw(seed, log_odds, state)) return;
  csht::TargetTrack* const track = state.free_track();
  if (track == nullptr) return;
  const csht::ScanHistory& scans = state.scans();
  std::swap(track->cloud, state.fresh);
  track->begin({.log_odds = std::min(log_odds, life_.settled_log_odds),
                .log_density = log_density_,
                .first_scan = scans.pushed() - 1 - window_.oldest,
                .first_utime = scans.at_age(seed.start_age).utime,
                .utime = state.now()});
  observer_.claim_memory(state.slot_of(*track), *track, csht::memory_of(*track, scans, memory_),
                         state.likelihood);
  state.decide(*track, DecisionKind::begin, track->log_odds, "echoes that no track explains");
}

}  // namespace lookout::tracking
