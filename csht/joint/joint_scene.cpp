#include "csht/joint/joint_scene.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

int capacity_of(const JointEngineParams& params, const core::SonarParams& sonar) {
  const double seconds = std::max(params.cloud.memory_s, params.birth.window_s);
  return params.scans_kept.value_or(1 + static_cast<int>(std::ceil(seconds / sonar.scan_period)));
}

SensorModelParams model_of(const JointEngineParams& params, const core::SonarParams& sonar) {
  SensorModelParams model = params.sensor;
  model.clutter = clutter_model_of(sonar);
  return model;
}

}  // namespace

JointScene::JointScene(const JointEngineParams& params, const core::SonarParams& sonar,
                       const DrawSource& source)
    : prior(params.prior, sonar.max_speed, sonar.scan_period),
      random(source.seed, source.stream),
      wander(sonar),
      likelihood(figures_of(sonar), model_of(params, sonar), params.tolerance, capacity_of(params, sonar),
                 params.hypotheses.max_tracks, prior),
      sampler(params.cloud, prior, random),
      undetected(params.birth, prior),
      clutter(params.clutter, sonar),
      source_(source),
      sonar_(sonar),
      learning_(params.learning),
      learnings_{SensorLearning(params.learning, sonar)},
      looks_anew_(params.scans_kept.has_value()),
      max_tracks_(static_cast<std::size_t>(params.hypotheses.max_tracks)) {
  likelihood.set_figures(learning().figures());
  likelihood.set_wander(wander);
  const auto largest = static_cast<std::size_t>(params.cloud.trajectories);
  fresh.reserve(largest);
  tracks.reserve(max_tracks_);
  tracks.resize(std::min(max_tracks_, static_cast<std::size_t>(params.hypotheses.ready_tracks)));
  for (TargetTrack& track : tracks) {
    track.cloud.reserve(largest);
    track.log_ratio.reserve(largest);
  }
}

double JointScene::take(const core::PosedScan& scan) {
  random.reseed(source_.seed, source_.stream, static_cast<std::uint64_t>(scan.scan.sequence));
  newest_sensor_ = static_cast<std::size_t>(looks_.take(scan.scan.sensor_id, scan.scan.utime));
  push(scan);
  clutter.price_newest(likelihood);
  const double seconds = scans().size() < 2 ? 0.0 : -scans().seconds_at_age(1);
  undetected.update(scans().newest(), scans().figures(), seconds);
  return seconds;
}

void JointScene::push(const core::PosedScan& scan) {
  while (learnings_.size() <= newest_sensor_) {
    learnings_.emplace_back(learning_, sonar_);
    if (scans().size() == 0) likelihood.set_figures(learnings_.back().figures());
  }
  likelihood.push(scan, looks_anew_ ? 1.0 : undetected.relative(), static_cast<int>(newest_sensor_));
}

void JointScene::learn() {
  learnings_[newest_sensor_].learn(tracks, likelihood);
  if (!stopped()) clutter.learn(tracks, likelihood, stopped);
}

TargetTrack* JointScene::free_track() {
  auto free = std::find_if(tracks.begin(), tracks.end(), [](const TargetTrack& t) { return !t.used; });
  if (free == tracks.end()) {
    if (tracks.size() == max_tracks_) return nullptr;
    tracks.emplace_back();
    free = tracks.end() - 1;
  }
  free->id = ++last_id_;
  return &*free;
}

void JointScene::release(TargetTrack& track) {
  track.used = false;
  likelihood.set_existence(slot_of(track), 0.0);
  likelihood.forget_claims(slot_of(track));
}

void JointScene::set_expected_targets(double expected) {
  prior.set_expected_targets(expected);
  likelihood.set_prior(prior);
}

}  // namespace lookout::csht
