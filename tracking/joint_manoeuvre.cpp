#include "tracking/joint_manoeuvre.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracking/joint_memory.hpp"

namespace lookout::tracking {
SamplingTask JointManoeuvre::task(const Suspect& suspect, const AgeSpan& ages, bool curved) const {
  SamplingTask task;
  task.guess = suspect.track.moments;
  const double position = params_.position_slack, velocity = params_.velocity_slack,
               acceleration = params_.acceleration_slack;
  for (int k = 0; k < 2; ++k) {
    task.guess.covariance(k, k) += position * position;
    task.guess.covariance(k + 2, k + 2) += velocity * velocity;
    if (!suspect.track.cloud.curved) task.guess.covariance(k + 4, k + 4) += acceleration * acceleration;
  }
  task.ages = ages;
  task.self = suspect.slot;
  task.samples = 2 * trajectories_;
  task.rounds = params_.rounds;
  task.curved = curved;
  return task;
}

SamplingTask JointManoeuvre::anchored_task(const Suspect& suspect, const AgeSpan& ages, bool curved,
                                           const csht::ScanHistory& scans) const {
  SamplingTask result = task(suspect, ages, curved);
  result.anchor = anchor(suspect.track.moments, scans.seconds_at_age(ages.oldest));
  return result;
}

Anchor JointManoeuvre::anchor(const CloudMoments& moments, double seconds) const {
  Eigen::Matrix<double, 4, 6> back = Eigen::Matrix<double, 4, 6>::Zero();
  for (int k = 0; k < 2; ++k) {
    back(k, k) = back(k + 2, k + 2) = 1.0;
    back(k, k + 2) = back(k + 2, k + 4) = seconds;
    back(k, k + 4) = 0.5 * seconds * seconds;
  }
  Anchor anchor{seconds, back * moments.mean, back * moments.covariance * back.transpose()};
  anchor.covariance.diagonal().head<2>().array() += params_.position_slack * params_.position_slack;
  anchor.covariance.diagonal().tail<2>().array() += params_.velocity_slack * params_.velocity_slack;
  return anchor;
}

JointManoeuvre::Judgement JointManoeuvre::judge(const Suspect& suspect, JointLikelihood& likelihood,
                                                JointSampler& sampler, core::Random& random,
                                                JointCloud& cloud) const {
  return suspect.track.cloud.curved ? leave_curve(suspect, likelihood, sampler, random, cloud)
                                    : leave_line(suspect, likelihood, sampler, random, cloud);
}

int JointManoeuvre::oldest_of_window(const csht::ScanHistory& scans) const {
  return oldest_of_curve({.curve_s = params_.window_s, .curve_scans = params_.least_scans}, scans);
}

// Whether the line explains the latest scans so poorly that a curve is worth its computing.
bool JointManoeuvre::doubtful(const RecentEvidence& recent, int scans) const {
  const int few = std::min(scans, params_.sudden_scans);
  return recent.sum(scans) < params_.trigger_share * recent.expected(scans) ||
         recent.sum(few) < recent.expected(few) - params_.sudden_nats;
}

// The line is judged by how well it predicted the window's scans one by one (were it the best line of a young
// track); the curve by its evidence over them, starting about where the line was.
JointManoeuvre::Judgement JointManoeuvre::leave_line(const Suspect& suspect, JointLikelihood& likelihood,
                                                     JointSampler& sampler, core::Random& random,
                                                     JointCloud& cloud) const {
  const RecentEvidence& recent = suspect.track.recent;
  const int oldest = std::min(oldest_of_window(likelihood.scans()), recent.size() - 1);
  Judgement judgement;
  if (oldest < params_.least_scans || !doubtful(recent, oldest + 1)) return judgement;
  judgement.oldest = oldest;
  const bool young = suspect.track.remembers_birth && recent.size() <= params_.young_windows * (oldest + 1);
  const double gain = young ? gain_of_other_line(suspect, likelihood, sampler, random, cloud) : 0.0;
  if (gain > params_.redraw_nats) {
    judgement.evidence = gain;
    judgement.verdict = Verdict::redraw;
    return judgement;
  }
  const SamplingTask bent = anchored_task(suspect, {0, oldest}, true, likelihood.scans());
  const SamplingResult curve = sampler.sample(bent, likelihood, random, cloud);
  judgement.evidence = curve.log_evidence + std::log(params_.prior) - recent.sum(oldest + 1);
  const double needed = curve.effective_share > params_.trusted_share ? 0.0 : params_.rough_nats;
  if (judgement.evidence > needed) judgement.verdict = Verdict::curve;
  return judgement;
}

// By how much the best line about the present one explains the whole life better; `cloud` holds it.
double JointManoeuvre::gain_of_other_line(const Suspect& suspect, JointLikelihood& likelihood,
                                          JointSampler& sampler, core::Random& random,
                                          JointCloud& cloud) const {
  SamplingTask present = task(suspect, suspect.memory, false);
  present.guess = suspect.track.moments;
  const SamplingResult own = sampler.sample(present, likelihood, random, cloud);
  const SamplingResult other =
      sampler.sample(task(suspect, suspect.memory, false), likelihood, random, cloud);
  return other.effective_share > params_.trusted_share ? other.log_evidence - own.log_evidence : 0.0;
}

// Both models from the same vague start: the line wins by needing less.
JointManoeuvre::Judgement JointManoeuvre::leave_curve(const Suspect& suspect, JointLikelihood& likelihood,
                                                      JointSampler& sampler, core::Random& random,
                                                      JointCloud& cloud) const {
  Judgement judgement;
  judgement.oldest = oldest_of_window(likelihood.scans());
  const AgeSpan window{0, judgement.oldest};
  const csht::ScanHistory& scans = likelihood.scans();
  const SamplingResult curve =
      sampler.sample(anchored_task(suspect, window, true, scans), likelihood, random, cloud);
  const SamplingResult line =
      sampler.sample(anchored_task(suspect, window, false, scans), likelihood, random, cloud);
  judgement.evidence = line.log_evidence - curve.log_evidence;
  if (judgement.evidence > params_.straighten_nats && line.effective_share > params_.trusted_share)
    judgement.verdict = Verdict::straighten;
  return judgement;
}

}  // namespace lookout::tracking
