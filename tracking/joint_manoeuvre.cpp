#include "tracking/joint_manoeuvre.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracking/joint_memory.hpp"

namespace lookout::tracking {
namespace {

constexpr int kRounds = 10;  // Of adaptive importance sampling: the guess may be some metres off.

}  // namespace

SamplingTask JointManoeuvre::task(int slot, const JointTrack& track, int oldest, bool curved) const {
  SamplingTask task;
  task.guess = track.moments;
  const double position = params_.position_slack, velocity = params_.velocity_slack,
               acceleration = params_.acceleration_slack;
  for (int k = 0; k < 2; ++k) {
    task.guess.covariance(k, k) += position * position;
    task.guess.covariance(k + 2, k + 2) += velocity * velocity;
    if (!track.cloud.curved) task.guess.covariance(k + 4, k + 4) += acceleration * acceleration;
  }
  task.ages = {0, oldest};
  task.self = slot;
  task.samples = 2 * trajectories_;
  task.rounds = kRounds;
  task.curved = curved;
  return task;
}

JointManoeuvre::Judgement JointManoeuvre::judge(int slot, const JointTrack& track,
                                                JointLikelihood& likelihood, JointSampler& sampler,
                                                core::Random& random, JointCloud& cloud) const {
  return track.cloud.curved ? leave_curve(slot, track, likelihood, sampler, random, cloud)
                            : leave_line(slot, track, likelihood, sampler, random, cloud);
}

// Whether the line explains the latest scans so poorly that a curve is worth its computing.
bool JointManoeuvre::doubtful(const RecentEvidence& recent, int scans) const {
  const int few = std::min(scans, params_.sudden_scans);
  return recent.sum(scans) < params_.trigger_share * recent.expected(scans) ||
         recent.sum(few) < recent.expected(few) - params_.sudden_nats;
}

// The line is judged by how well it predicted the window's scans one by one; the curve by its evidence over
// them, starting about where the line was.
JointManoeuvre::Judgement JointManoeuvre::leave_line(int slot, const JointTrack& track,
                                                     JointLikelihood& likelihood, JointSampler& sampler,
                                                     core::Random& random, JointCloud& cloud) const {
  const int oldest = std::min(oldest_within(params_.window_s, likelihood.scans()), track.recent.size() - 1);
  Judgement judgement;
  if (oldest < params_.least_scans || !doubtful(track.recent, oldest + 1)) return judgement;
  const double predicted = track.recent.sum(oldest + 1);
  const double log_start = -std::log(4.0 * std::numbers::pi * std::numbers::pi) -
                           2.0 * std::log(params_.position_slack * params_.velocity_slack);
  SamplingTask curve = task(slot, track, oldest, true);
  const SamplingResult result = sampler.sample(curve, likelihood, random, cloud);
  judgement.evidence = result.log_evidence + log_start + std::log(params_.prior) - predicted;
  judgement.oldest = oldest;
  const double needed = result.effective_share > params_.trusted_share ? 0.0 : params_.rough_nats;
  if (judgement.evidence > needed) judgement.verdict = Verdict::curve;
  return judgement;
}

// Both models from the same vague start: the line wins by needing less.
JointManoeuvre::Judgement JointManoeuvre::leave_curve(int slot, const JointTrack& track,
                                                      JointLikelihood& likelihood, JointSampler& sampler,
                                                      core::Random& random, JointCloud& cloud) const {
  const int oldest = oldest_within(params_.window_s, likelihood.scans());
  Judgement judgement;
  judgement.oldest = oldest;
  const SamplingResult curve = sampler.sample(task(slot, track, oldest, true), likelihood, random, cloud);
  const SamplingResult line = sampler.sample(task(slot, track, oldest, false), likelihood, random, cloud);
  judgement.evidence = line.log_evidence - curve.log_evidence;
  if (judgement.evidence > params_.straighten_nats && line.effective_share > params_.trusted_share)
    judgement.verdict = Verdict::straighten;
  return judgement;
}

}  // namespace lookout::tracking
