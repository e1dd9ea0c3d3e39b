#include "tracking/joint/scan_update.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "csht/joint/evidence/scan_information.hpp"
#include "csht/joint/evidence/was_in_view.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSureExistence = 0.9;  // Of a target whose returns tell how large the sensor's errors are.

bool in_view(const Eigen::Vector2d& p_earth, const csht::ScanTable& scan) {
  const Eigen::Vector2d from = p_earth - Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
  const int beam = csht::beam_at(scan, p_earth.x(), p_earth.y());
  return from.norm() <= scan.max_range && beam >= 0 && beam < scan.num_beams;
}

// Whether a sonar that still looks has a place in view, each at its newest scan.
bool in_view_of_any(const Eigen::Vector2d& p_earth, const TrackerState& state) {
  const csht::ScanHistory& scans = state.scans();
  const std::int64_t oldest = std::min(state.looks().oldest(), scans.newest().utime);
  for (int age = 0; age < scans.size() && scans.at_age(age).utime >= oldest; ++age)
    if (in_view(p_earth, scans.at_age(age))) return true;
  return false;
}

double share_in_view(const csht::TrajectoryCloud& cloud, const TrackerState& state) {
  double share = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (in_view_of_any({cloud.north[i], cloud.east[i]}, state)) share += cloud.weight[i];
  return share;
}

}  // namespace

ScanUpdate::ScanUpdate(const JointTrackerParams& params)
    : cloud_(params.cloud),
      life_(params.life),
      settled_log_odds_(params.hypotheses.settled_log_odds),
      memory_{params.cloud.memory_s, params.manoeuvre.memory_s, params.manoeuvre.least_scans},
      manoeuvre_(params.manoeuvre, params.cloud.trajectories),
      claims_(params.claims) {}

void ScanUpdate::predict(double seconds, TrackerState& state) const {
  const double survival = std::exp(-seconds / life_.mean_life_s);
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    track.advance(seconds);
    stray(seconds, track, state);
    track.log_odds = csht::log_odds(track.existence() * survival);
  }
}

void ScanUpdate::stray(double seconds, csht::TargetTrack& track, TrackerState& state) const {
  if (!state.wander.active()) return;
  state.wander.stray(seconds, state.random, track.cloud);
  track.moments = track.cloud.moments();
}

void ScanUpdate::update(TrackerState& state) {
  claim_provisionally(state);
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    if (state.stopped()) return;
    const double missed_before = 1.0 - track.detected_share;
    take_scan(track, state);
    judge_motion(track, state);
    claims_.claim_memory(state.slot_of(track), track, csht::memory_of(track, state.scans(), memory_),
                         state.likelihood);
    if (track.confirmed_once) track.log_odds += missed_before * excess_of_misses(track, state);
  }
}

// Each track claims what it would take of the scan if it were alone, so that all know of each other before
// the first is updated.
void ScanUpdate::claim_provisionally(TrackerState& state) {
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    if (state.stopped()) return;
    const int self = state.slot_of(track);
    track.log_ratio.assign(track.cloud.size(), 0.0);
    state.likelihood.add(track.cloud, track.moments.mean, {0, 0}, csht::ScanLikelihood::kEverybody,
                         track.log_ratio);
    state.likelihood.set_existence(self, track.existence());
    if (track.existence() < csht::ScanLikelihood::kLeastExistence) continue;
    state.fresh = track.cloud;
    state.fresh.reweigh(track.log_ratio);
    claims_.claim(self, state.fresh, state.likelihood);
  }
}

// What the newest scan took too much from the odds of a track that was missed before: misses are no
// independent events.
double ScanUpdate::excess_of_misses(const csht::TargetTrack& track, const TrackerState& state) const {
  if (state.scans().newest().clutter != csht::ClutterModel::point) return 0.0;
  const double alone = state.scans().figures().miss_probability;
  const double missed = std::max(0.0, track.visible_share - track.detected_share);
  return missed * std::log(std::max(1.0, life_.missed_again / alone));
}

void ScanUpdate::take_scan(csht::TargetTrack& track, TrackerState& state) {
  const int self = state.slot_of(track);
  const csht::ScanHistory& scans = state.scans();
  const int beam = std::max(0, csht::beam_at(scans.newest(), track.moments.mean[0], track.moments.mean[1]));
  const bool shared = state.likelihood.mask(0, self, beam) != nullptr;
  if (shared) {
    track.log_ratio.assign(track.cloud.size(), 0.0);
    state.likelihood.add(track.cloud, track.moments.mean, {0, 0}, self, track.log_ratio);
  }
  if (track.existence() > kSureExistence && !track.out_of_view)
    state.learning().weigh_errors(track.cloud, shared ? state.likelihood.mask(0, self, beam) : nullptr,
                                  scans.newest());
  const double evidence = track.cloud.reweigh(track.log_ratio);
  track.log_odds += evidence;
  track.highest_log_odds = std::max(track.highest_log_odds, track.log_odds);
  const bool looked_at = !state.looks().several() || in_view(track.moments.mean.head<2>(), scans.newest());
  const bool tells =
      looked_at && !track.out_of_view && !(shared && state.likelihood.contested(self, track.moments.mean));
  track.recent.add(evidence, tells ? csht::nats_per_scan(scans.figures(), scans.newest()) : evidence);
  const double enough = cloud_.refresh_share * static_cast<double>(track.cloud.size());
  if (track.cloud.motion == csht::Motion::constant_acceleration || track.cloud.effective_size() < enough)
    refresh(track, state);
  track.moments = track.cloud.moments();
}

// Whether a density drawn anew leads out of view of all sonars a track that was in view of one, though the
// newest scan may be another's, or to where none ever had a view. Nothing speaks against the trajectories
// there: they are those of targets that were never heard, and there is no end to them.
bool ScanUpdate::leads_away(const csht::TrajectoryCloud& drawn, const csht::TargetTrack& track,
                            const TrackerState& state) const {
  if (share_in_view(drawn, state) >= life_.in_view_share) return false;
  const int oldest = csht::memory_of(track, state.scans(), memory_).oldest;
  return share_in_view(track.cloud, state) >= life_.in_view_share ||
         !csht::was_in_view(drawn.moments(), state.scans(), oldest);
}

// Draws the cloud anew under the likelihood of the scans that the track remembers: settled tracks by moving
// their trajectories ([Gilks2001] Sec. 3), others by importance sampling ([Cappe2004] Sec. 2).
// Out of view no scan says anything new.
void ScanUpdate::refresh(csht::TargetTrack& track, TrackerState& state) {
  if (track.out_of_view) return;
  csht::SamplingTask task;
  task.guess = track.cloud.moments();
  // A few trajectories say little of their spread: the less, the more of the spread before the scan is added.
  const double rest = std::min(1.0, csht::dimensions(track.cloud.motion) / track.cloud.effective_size());
  task.guess.covariance += rest * track.moments.covariance;
  task.ages = csht::memory_of(track, state.scans(), memory_);
  task.self = state.slot_of(track);
  task.samples = cloud_.trajectories;
  task.rounds = cloud_.refresh_rounds;
  if (track.cloud.motion != csht::Motion::constant_velocity && !task.ages.births)
    task.anchor = manoeuvre_.anchor(task.guess, state.scans().seconds_at_age(task.ages.oldest));
  if (track.log_odds >= settled_log_odds_ && track.cloud.motion != csht::Motion::constant_acceleration) {
    state.sampler.move(task, state.likelihood, state.random, track.cloud);
    track.claims_are_fresh = false;
    return;
  }
  const csht::SamplingResult result = state.sampler.sample(task, state.likelihood, state.random, state.fresh);
  const double effective = result.effective_share * static_cast<double>(task.samples);
  if (effective <= std::min(track.cloud.effective_size(), cloud_.enough_effective)) return;
  if (leads_away(state.fresh, track, state)) return;
  std::swap(track.cloud, state.fresh);
  track.claims_are_fresh = false;
  if (tells_odds(track, task.ages, result, state)) estimate_odds(result.log_evidence, track);
}

// Whether a sampling also estimates the odds. A track began because its odds were the best of many, so they
// are too high on average; those of a new sampling over its whole life are not. docs/joint_tracker.md.
bool ScanUpdate::tells_odds(const csht::TargetTrack& track, const csht::AgeSpan& ages,
                            const csht::SamplingResult& result, const TrackerState& state) const {
  const bool whole_life = ages.births && ages.oldest == state.scans().pushed() - 1 - track.first_scan;
  return whole_life && result.effective_share > cloud_.trusted_share;
}

void ScanUpdate::judge_motion(csht::TargetTrack& track, TrackerState& state) {
  if (track.out_of_view) return;
  const csht::AgeSpan memory = csht::memory_of(track, state.scans(), memory_);
  const auto judgement = manoeuvre_.judge({state.slot_of(track), track, memory}, state.likelihood,
                                          state.sampler, state.random, state.fresh);
  if (judgement.verdict == MotionChange::Verdict::keep || leads_away(state.fresh, track, state)) return;
  const csht::Motion before = track.cloud.motion;
  std::swap(track.cloud, state.fresh);
  track.moments = track.cloud.moments();
  track.claims_are_fresh = false;
  // A constant turn starts with a clean record, and is judged once it has predicted enough scans by itself.
  if (track.cloud.motion == csht::Motion::constant_turn) track.recent.clear();
  if (judgement.verdict == MotionChange::Verdict::rewrite)
    estimate_odds(judgement.life_evidence, track);
  else
    change_model(judgement, track, state);
  if (track.cloud.motion != before) tell_change(judgement, track, state);
}

// Sets the odds of a track by the evidence for its whole life: prior density times evidence, as at its birth.
// A settled track keeps its odds.
void ScanUpdate::estimate_odds(double life_evidence, csht::TargetTrack& track) const {
  const double odds = life_evidence + track.log_density + manoeuvre_.log_share(track.cloud.motion);
  if (track.log_odds < settled_log_odds_) track.log_odds = std::min(odds, settled_log_odds_);
}

void ScanUpdate::change_model(const MotionChange::Judgement& judgement, csht::TargetTrack& track,
                              const TrackerState& state) const {
  track.first_scan = state.scans().pushed() - 1 - judgement.oldest;
  track.remembers_birth = false;
  // What the odds lost while the old motion fitted poorly was no evidence against the target.
  if (track.cloud.motion != csht::Motion::constant_velocity)
    track.log_odds =
        std::max(track.log_odds, std::min(track.log_odds + judgement.evidence, settled_log_odds_));
}

void ScanUpdate::tell_change(const MotionChange::Judgement& judgement, const csht::TargetTrack& track,
                             const TrackerState& state) const {
  const csht::Motion motion = track.cloud.motion;
  state.decide(track,
               motion == csht::Motion::constant_velocity ? DecisionKind::steady : DecisionKind::manoeuvre,
               judgement.evidence,
               motion == csht::Motion::constant_velocity ? "a straight line explains the scans as well"
               : motion == csht::Motion::constant_turn   ? "a turn explains the scans better"
                                                         : "a curve explains the scans better");
}

}  // namespace lookout::tracking
