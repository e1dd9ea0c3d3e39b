#include "tracking/latency.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lookout::tracking {
namespace {

// (north, east, north velocity, east velocity), so many seconds on.
Eigen::Matrix4d transition(double seconds) {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result(0, 2) = result(1, 3) = seconds;
  return result;
}

}  // namespace

LateScanTracker::LateScanTracker(std::unique_ptr<Tracker> tracker, std::int64_t latency)
    : tracker_(std::move(tracker)), latency_(latency) {
  assert(tracker_ != nullptr && latency > 0);
}

std::span<const core::Track> LateScanTracker::update(const core::PosedScan& scan) {
  scan_ = scan;
  scan_.scan.utime -= latency_;
  move_on(tracker_->update(scan_), core::seconds(latency_));
  move_on(tracker_->elements(), core::seconds(latency_));
  return tracks_;
}

void LateScanTracker::explain_to(DecisionLog log) {
  if (!log) return tracker_->explain_to(nullptr);
  tracker_->explain_to([log = std::move(log), latency = latency_](TrackDecision decision) {
    decision.utime += latency;
    log(decision);
  });
}

// The newest that the tracker within knows is `latency` old; beyond it tracks are moved on.
std::span<const core::Track> LateScanTracker::retrodict(std::int64_t utime) {
  const std::int64_t known = std::min(utime, scan_.scan.utime);
  move_on(tracker_->retrodict(known), core::seconds(utime - known));
  return tracks_;
}

void LateScanTracker::move_on(std::span<const core::Track> tracks, double seconds) {
  const Eigen::Matrix4d on = transition(seconds);
  tracks_.assign(tracks.begin(), tracks.end());
  for (core::Track& track : tracks_) {
    track.state = on * track.state;
    track.covariance = on * track.covariance * on.transpose();
  }
}

void LateScanTracker::move_on(std::span<const core::MotionElement> elements, double seconds) {
  const Eigen::Matrix4d on = transition(seconds);
  elements_.assign(elements.begin(), elements.end());
  for (core::MotionElement& element : elements_) {
    element.position += seconds * element.velocity;
    element.covariance = on * element.covariance * on.transpose();
  }
}

std::unique_ptr<Tracker> make_up_for_latency(std::unique_ptr<Tracker> tracker,
                                             const core::SonarParams& sonar) {
  const std::int64_t latency = core::microseconds(sonar.latency);
  if (latency <= 0) return tracker;
  return std::make_unique<LateScanTracker>(std::move(tracker), latency);
}

}  // namespace lookout::tracking
