#include "tracking/joint/joint_tracker.hpp"

#include <utility>

namespace lookout::tracking {
namespace {

const JointTrackerParams& validated(const JointTrackerParams& params) {
  validate(params);
  return params;
}

}  // namespace

JointTracker::JointTracker(const JointTrackerParams& params, const core::SonarParams& sonar,
                           std::uint64_t seed, std::unique_ptr<BirthMethod> births)
    : params_(validated(params)),
      seed_(seed),
      state_(params, sonar, seed),
      unseen_(params.birth, state_.prior),
      filter_(params),
      heading_(params.heading),
      onset_(params, state_.prior, std::move(births)),
      ending_(params.life),
      output_(params.report, state_.random),
      learning_(params.learning, params.report.min_existence, sonar) {
  state_.likelihood.set_figures(learning_.figures());
}

std::span<const core::Track> JointTracker::update(const core::PosedScan& scan) {
  take(scan);
  filter_.update(state_);
  ending_.end_twins(state_);
  onset_.begin(scan, state_);
  ending_.end_lives(state_);
  output_.choose(unseen_.mean(), state_);
  learning_.learn(state_);
  return output_.publish(state_);
}

void JointTracker::take(const core::PosedScan& scan) {
  state_.random.reseed(seed_, core::RandomStream::tracker, static_cast<std::uint64_t>(scan.scan.sequence));
  state_.likelihood.push(scan, unseen_.relative());
  const csht::ScanHistory& scans = state_.scans();
  const double seconds = scans.size() < 2 ? 0.0 : -scans.seconds_at_age(1);
  unseen_.update(scans.newest(), scans.figures(), seconds);
  state_.retrodiction.forget_before(scans.at_age(scans.size() - 1).utime);
  filter_.predict(seconds, state_);
  heading_.refine(state_);
}

std::span<const core::Track> JointTracker::retrodict(std::int64_t utime) {
  return state_.retrodiction.at(utime, state_.tracks, state_.scans(), params_.report.min_existence);
}

}  // namespace lookout::tracking
