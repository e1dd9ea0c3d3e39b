#include "tracking/joint/motion_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csht/joint/evidence/memory_span.hpp"

namespace lookout::tracking {
MotionChange::MotionChange(const MotionChangeParams& params, int trajectories)
    : params_(params), samples_(trajectories) {
  other_.reserve(static_cast<std::size_t>(samples_));
}

csht::SamplingTask MotionChange::task(const Suspect& suspect, const csht::AgeSpan& ages,
                                      csht::Motion motion) const {
  csht::SamplingTask task;
  task.guess = loosened(suspect.track.moments, motion);
  task.ages = ages;
  task.self = suspect.slot;
  task.samples = samples_;
  task.rounds = params_.rounds;
  return task;
}

csht::SamplingTask MotionChange::anchored_task(const Suspect& suspect, const csht::AgeSpan& ages,
                                               csht::Motion motion, const csht::ScanHistory& scans) const {
  csht::SamplingTask result = task(suspect, ages, motion);
  result.anchor = anchor(suspect.track.moments, scans.seconds_at_age(ages.oldest));
  return result;
}

// A first guess for another motion: the moments of the present one, what acceleration and turn rate share
// carried over, widened by what a manoeuvre may have led the target off.
csht::CloudMoments MotionChange::loosened(const csht::CloudMoments& moments, csht::Motion motion) const {
  csht::CloudMoments result = moments;
  result.motion = motion;
  const Eigen::Vector2d velocity = moments.mean.segment<2>(2), acceleration = moments.mean.tail<2>();
  if (motion != moments.motion) {
    result.mean.tail<2>().setZero();
    result.covariance.bottomRows<2>().setZero();
    result.covariance.rightCols<2>().setZero();
    if (motion == csht::Motion::constant_acceleration && moments.motion == csht::Motion::constant_turn)
      result.mean.tail<2>() = moments.mean[4] * Eigen::Vector2d(-velocity.y(), velocity.x());
    if (motion == csht::Motion::constant_turn && moments.motion == csht::Motion::constant_acceleration)
      result.mean[4] = (velocity.x() * acceleration.y() - velocity.y() * acceleration.x()) /
                       std::max(velocity.squaredNorm(), params_.velocity_slack * params_.velocity_slack);
    const double slack =
        motion == csht::Motion::constant_turn ? params_.turn_slack : params_.acceleration_slack;
    result.covariance.diagonal().tail<2>().setConstant(slack * slack);
  }
  result.covariance.diagonal().head<2>().array() += params_.position_slack * params_.position_slack;
  result.covariance.diagonal().segment<2>(2).array() += params_.velocity_slack * params_.velocity_slack;
  return result;
}

csht::Anchor MotionChange::anchor(const csht::CloudMoments& moments, double seconds) const {
  const csht::StateMoments then =
      csht::state_moments_at(moments.motion, moments.mean, moments.covariance, seconds);
  csht::Anchor anchor{seconds, then.mean, then.covariance};
  anchor.covariance.diagonal().head<2>().array() += params_.position_slack * params_.position_slack;
  anchor.covariance.diagonal().tail<2>().array() += params_.velocity_slack * params_.velocity_slack;
  return anchor;
}

MotionChange::Judgement MotionChange::judge(const Suspect& suspect, csht::ScanLikelihood& likelihood,
                                            csht::TrajectorySampler& sampler, core::Random& random,
                                            csht::TrajectoryCloud& cloud) {
  const Bench bench{likelihood, sampler, random, cloud};
  const int window = oldest_of_window(likelihood.scans());
  const csht::Motion motion = suspect.track.cloud.motion;
  const bool young = suspect.memory.oldest <= params_.young_windows * window;
  if (suspect.memory.births && young) return doubt_life(suspect, bench);
  if (suspect.track.highest_log_odds < params_.least_log_odds) return {};
  if (motion == csht::Motion::constant_acceleration) return compare(suspect, window, bench);
  if (motion == csht::Motion::constant_turn && young) return compare(suspect, suspect.memory.oldest, bench);
  return doubt(suspect, bench);
}

int MotionChange::oldest_of_window(const csht::ScanHistory& scans) const {
  return csht::oldest_within(params_.window_s, params_.least_scans, scans);
}

// Whether the motion explains the latest scans so poorly that others are worth the time to try them.
bool MotionChange::doubtful(const csht::RecentEvidence& recent, int scans) const {
  const int few = std::min(scans, params_.sudden_scans);
  return recent.sum(scans) < params_.trigger_share * recent.expected(scans) ||
         recent.sum(few) < recent.expected(few) - params_.sudden_nats;
}

double MotionChange::log_share(csht::Motion motion) const {
  return motion == csht::Motion::constant_velocity ? 0.0 : std::log(params_.curved_share);
}

// Tries motions over the whole life of a young track, each sampled anew from about where the track is.
// Constant velocity is judged only when it fits poorly, and may also give way to other trajectories at
// constant velocity; the other motions are judged at every scan.
MotionChange::Judgement MotionChange::doubt_life(const Suspect& suspect, const Bench& bench) {
  const csht::TargetTrack& track = suspect.track;
  const csht::ScanHistory& history = bench.likelihood.scans();
  const int scans = std::min(track.recent.size(), 1 + oldest_of_window(history));
  if (track.log_odds < params_.life_log_odds) return {};
  if (suspect.memory.oldest < params_.least_scans || scans < params_.sudden_scans) return {};
  const csht::Motion present = track.cloud.motion;
  if (present == csht::Motion::constant_velocity && !doubtful(track.recent, scans)) return {};
  csht::SamplingTask same = task(suspect, suspect.memory, present);
  same.guess = track.moments;
  same.rounds = params_.present_rounds;
  const csht::SamplingResult own = bench.sampler.sample(same, bench.likelihood, bench.random, other_);
  Judgement best{.evidence = params_.redraw_nats};
  for (const csht::Motion motion : motions_to_try(suspect, history)) {
    if (motion == present && motion != csht::Motion::constant_velocity) continue;
    const csht::SamplingResult result =
        bench.sampler.sample(task(suspect, suspect.memory, motion), bench.likelihood, bench.random, other_);
    const double gain = result.log_evidence + log_share(motion) - own.log_evidence - log_share(present);
    if (result.effective_share <= params_.trusted_share || gain <= best.evidence) continue;
    best = {Verdict::rewrite, gain, suspect.memory.oldest, result.log_evidence};
    std::swap(other_, bench.cloud);
  }
  return best;
}

// Constant acceleration, which fits any manoeuvre for a while, and in turns, scan by scan, one of the other
// two: all three at once would make some scans several times as expensive as others.
std::array<csht::Motion, 2> MotionChange::motions_to_try(const Suspect& suspect,
                                                         const csht::ScanHistory& scans) const {
  const bool even = (scans.pushed() + suspect.slot) % 2 == 0;
  return {even ? csht::Motion::constant_velocity : csht::Motion::constant_turn,
          csht::Motion::constant_acceleration};
}

// The present motion has as its evidence how well it predicted the scans of the window, one by one. Another
// has the evidence of sampling it over the same scans, from about where the track was before them, and must
// make up for the prior probability of a manoeuvre: a sequential test, [Wald1945].
MotionChange::Judgement MotionChange::doubt(const Suspect& suspect, const Bench& bench) {
  const csht::RecentEvidence& recent = suspect.track.recent;
  const int oldest = std::min(oldest_of_window(bench.likelihood.scans()), recent.size() - 1);
  Judgement judgement;
  if (oldest < params_.least_scans || !doubtful(recent, oldest + 1)) return judgement;
  judgement.oldest = oldest;
  const double needed = recent.sum(oldest + 1) - std::log(params_.prior);
  double best = try_motion(csht::Motion::constant_acceleration, -std::numeric_limits<double>::infinity(),
                           suspect, {0, oldest}, bench);
  if (best > needed - params_.hopeless_nats) {
    const double constant_turn_needs = best + params_.constant_turn_nats;
    const double turn =
        try_motion(csht::Motion::constant_turn, constant_turn_needs, suspect, {0, oldest}, bench);
    if (turn > constant_turn_needs) best = turn;
    if (suspect.track.cloud.motion != csht::Motion::constant_velocity)
      best = try_motion(csht::Motion::constant_velocity, best, suspect, {0, oldest}, bench);
  }
  judgement.evidence = best - needed;
  if (judgement.evidence > 0.0) judgement.verdict = Verdict::change;
  return judgement;
}

// The evidence for a motion over some scans, less `rough_nats` where few trajectories carry it. Where it is
// better than `best`, `bench.cloud` takes its trajectories; else the answer is `best`.
double MotionChange::try_motion(csht::Motion motion, double best, const Suspect& suspect,
                                const csht::AgeSpan& ages, const Bench& bench) {
  const csht::SamplingTask task = anchored_task(suspect, ages, motion, bench.likelihood.scans());
  const csht::SamplingResult result = bench.sampler.sample(task, bench.likelihood, bench.random, other_);
  const bool trusted = result.effective_share > params_.trusted_share;
  const double evidence = result.log_evidence - (trusted ? 0.0 : params_.rough_nats);
  if (evidence <= best) return best;
  std::swap(other_, bench.cloud);
  return evidence;
}

// Tries all motions from the same wide guess over the latest scans: one that needs fewer parameters wins
// where both fit, as its prior is less spread out.
MotionChange::Judgement MotionChange::compare(const Suspect& suspect, int oldest, const Bench& bench) {
  const csht::AgeSpan window{0, oldest};
  const csht::Motion motion = suspect.track.cloud.motion;
  const csht::SamplingTask same = anchored_task(suspect, window, motion, bench.likelihood.scans());
  const double present = bench.sampler.sample(same, bench.likelihood, bench.random, other_).log_evidence;
  const bool accelerates = motion == csht::Motion::constant_acceleration;
  const double needed = present + (accelerates ? 0.0 : params_.constant_acceleration_nats);
  const double other =
      try_motion(accelerates ? csht::Motion::constant_turn : csht::Motion::constant_acceleration, needed,
                 suspect, window, bench);
  const double constant_velocity_needs = std::max(other, present + params_.constant_velocity_nats);
  const double straight =
      try_motion(csht::Motion::constant_velocity, constant_velocity_needs, suspect, window, bench);
  const bool better = other > needed || straight > constant_velocity_needs;
  return {better ? Verdict::change : Verdict::keep, std::max(other, straight) - present, oldest};
}

}  // namespace lookout::tracking
