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
                           std::uint64_t seed, std::unique_ptr<BirthMethod> proposals)
    : params_(for_sensor(validated(params), sonar)),
      state_(params_, sonar, seed),
      scan_update_(params_),
      heading_(params_.heading),
      births_(params_, std::move(proposals)),
      deletion_(params_),
      confirmation_(params_.report, state_.random) {}

csht::Explained JointTracker::take(const core::PosedScan& scan) {
  const double seconds = state_.take(scan);
  state_.retrodiction.forget_before(state_.scans().at_age(state_.scans().size() - 1).utime);
  scan_update_.predict(seconds, state_);
  heading_.refine(state_);
  scan_update_.update(state_);
  deletion_.end_twins(state_);
  return {{}, births_.takes_elements() ? &state_ : nullptr};
}

std::span<const core::Track> JointTracker::update(const core::PosedScan& scan,
                                                  std::span<const core::MotionElement> elements) {
  births_.begin(scan, elements, state_);
  deletion_.end_lives(state_);
  confirmation_.choose(state_.undetected.mean(), state_);
  state_.learn();
  return confirmation_.publish(state_);
}

std::span<const core::Track> JointTracker::retrodict(std::int64_t utime) {
  return state_.retrodiction.at(utime, state_.tracks, state_.scans(), params_.report.min_existence);
}

}  // namespace lookout::tracking
