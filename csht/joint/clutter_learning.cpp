#include "csht/joint/clutter_learning.hpp"

#include <algorithm>
#include <cmath>

#include "csht/joint/evidence/memory_span.hpp"
#include "csht/likelihood/clutter_grid.hpp"

namespace lookout::csht {
namespace {

double background_rate(const ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const SensorFigures& figures = scans.figures();
  return scans.newest().clutter == ClutterModel::point
             ? figures.clutter_per_scan
             : figures.false_alarm_probability * scans.newest().num_beams;
}

}  // namespace

ClutterLearning::ClutterLearning(const ClutterLearningParams& params, const core::SonarParams& sonar)
    : params_(params),
      map_(params.map, sonar),
      spill_(params.spill),
      leave_out_s_(params.map.leave_out_time * sonar.range_sigma / sonar.max_speed),
      sure_age_s_(params.sure_age * sonar.range_sigma / sonar.max_speed),
      max_speed_(sonar.max_speed) {}

void ClutterLearning::price_newest(ScanLikelihood& likelihood) {
  if (!params_.map.enabled) return;
  const ScanTable& newest = likelihood.scans().newest();
  spill_.learn(newest, likelihood.scans().figures().false_alarm_probability);
  likelihood.group(0, spill_);
  if (background_.empty()) reserve(newest, likelihood.scans().capacity());
  background_[0].resize(newest.background.size());
  map_.price(newest, background_rate(likelihood), background_[0]);
  likelihood.set_background(0, background_[0]);
}

std::optional<core::ClutterGrid> ClutterLearning::grid(const ScanLikelihood& likelihood) const {
  if (!params_.map.enabled || likelihood.scans().size() == 0) return std::nullopt;
  return clutter_grid(map_, likelihood.scans().newest(), background_rate(likelihood));
}

void ClutterLearning::reserve(const ScanTable& scan, int scans) {
  background_.assign(static_cast<std::size_t>(scans), std::vector<float>(scan.background.size()));
  changed_.reserve(static_cast<std::size_t>(scans));
  own_.reserve(static_cast<std::size_t>(params_.map.most_returns));
}

void ClutterLearning::learn(std::span<TargetTrack> tracks, ScanLikelihood& likelihood) {
  if (!params_.map.enabled) return;
  const bool judges = likelihood.scans().pushed() % params_.judge_every == 0;
  const int settled = oldest_within(leave_out_s_, likelihood.scans());
  for (int age = settled; age < (judges ? likelihood.scans().size() : settled + 1); ++age)
    discount_movers(age, tracks, likelihood);
  map_.learn_standing(likelihood.scans().newest(), background_rate(likelihood));
  map_.add(likelihood.scans().newest());
  if (judges) judge_anew(tracks, likelihood);
}

// What a target was detected by is known once the scan is as old as those that do not judge each other.
void ClutterLearning::discount_movers(int age, std::span<const TargetTrack> tracks,
                                      const ScanLikelihood& likelihood) {
  const ScanTable& scan = likelihood.scans().at_age(age);
  moves_.assign(tracks.size(), 0);
  bool any = false;
  for (std::size_t k = 0; k < tracks.size(); ++k)
    any |= (moves_[k] = surely_moves(tracks[k], likelihood.scans().newest().utime) ? 1 : 0) != 0;
  if (!any) return;
  own_.clear();
  for (std::size_t j = 0; j < scan.detections.size(); ++j) {
    const core::Detection& detection = scan.detections[j];
    const bool point = scan.clutter == ClutterModel::point;
    own_.push_back(
        likelihood.explained(age, point ? static_cast<int>(j) : detection.beam, detection.range, moves_));
  }
  map_.discount(scan, own_, background_rate(likelihood));
}

bool ClutterLearning::surely_moves(const TargetTrack& track, std::int64_t now) const {
  if (!track.used || track.existence() < params_.sure_existence) return false;
  if (core::seconds(now - track.first_utime) < sure_age_s_) return false;
  const double speed = track.moments.mean.segment<2>(2).norm();
  const double sigma = std::sqrt(0.5 * (track.moments.covariance(2, 2) + track.moments.covariance(3, 3)));
  return sigma < params_.sure_sigma * max_speed_ && speed > params_.least_speed * max_speed_ + 2.0 * sigma;
}

void ClutterLearning::judge_anew(std::span<TargetTrack> tracks, ScanLikelihood& likelihood) {
  const ScanHistory& scans = likelihood.scans();
  const double rate = background_rate(likelihood);
  changed_.clear();
  for (int age = 0; age < scans.size(); ++age) {
    const std::vector<float>& before = scans.at_age(age).background;
    std::vector<float>& now = background_[static_cast<std::size_t>(age)];
    now.resize(before.size());
    likelihood.group(age, spill_);
    map_.price(scans.at_age(age), rate, now);
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (std::abs(now[k] - before[k]) <= static_cast<float>(params_.least_change) * before[k]) continue;
      changed_.push_back(age);
      break;
    }
  }
  if (changed_.empty()) return;
  for (TargetTrack& track : tracks) track.log_ratio.assign(track.cloud.size(), 0.0);
  add_evidence(-1.0, tracks, likelihood);
  for (const int age : changed_) likelihood.set_background(age, background_[static_cast<std::size_t>(age)]);
  add_evidence(1.0, tracks, likelihood);
  for (TargetTrack& track : tracks)
    if (track.used) take_change(track);
}

void ClutterLearning::add_evidence(double sign, std::span<TargetTrack> tracks, ScanLikelihood& likelihood) {
  for (std::size_t slot = 0; slot < tracks.size(); ++slot) {
    TargetTrack& track = tracks[slot];
    if (!track.used) continue;
    const std::int64_t life = likelihood.scans().pushed() - 1 - track.first_scan;
    ratio_.assign(track.cloud.size(), 0.0);
    for (const int age : changed_)
      if (age <= life)
        likelihood.add(track.cloud, track.moments.mean, {age, age, false}, static_cast<int>(slot), ratio_);
    for (std::size_t i = 0; i < ratio_.size(); ++i) track.log_ratio[i] += sign * ratio_[i];
  }
}

void ClutterLearning::take_change(TargetTrack& track) {
  track.log_odds += track.cloud.reweigh(track.log_ratio);
  track.moments = track.cloud.moments();
}

}  // namespace lookout::csht
