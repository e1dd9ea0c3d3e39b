#include "tracking/scan_pipeline.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/constant_velocity.hpp"

namespace lookout::tracking {

ScanPipeline::ScanPipeline(std::unique_ptr<csht::MotionEstimator> estimator, std::unique_ptr<Tracker> tracker,
                           std::int64_t latency)
    : estimator_(std::move(estimator)), tracker_(std::move(tracker)), latency_(latency) {
  assert(tracker_ != nullptr && latency >= 0);
}

PingResult ScanPipeline::step(const core::PosedScan& posed) {
  const core::PosedScan& scan = at_time_of_returns(posed);
  sensor_id_ = posed.scan.sensor_id;
  const csht::Explained explained = tracker_->take(scan);
  if (estimator_) estimator_->offer(explained);
  const auto elements = estimate(scan);
  const auto tracks = tracker_->update(scan, elements);
  PingResult result = describe(posed);
  result.elements = bring_to_scan(elements);
  result.tracks = bring_to_scan(tracks, core::seconds(latency_));
  return result;
}

const core::PosedScan& ScanPipeline::at_time_of_returns(const core::PosedScan& scan) {
  if (latency_ == 0) return scan;
  scan_ = scan;
  scan_.scan.utime -= latency_;
  return scan_;
}

std::span<const core::MotionElement> ScanPipeline::estimate(const core::PosedScan& scan) {
  if (!estimator_) return {};
  return estimator_->update(scan);
}

PingResult ScanPipeline::describe(const core::PosedScan& posed) const {
  const core::SonarScan& scan = posed.scan;
  PingResult result;
  result.utime = scan.utime;
  result.sequence = scan.sequence;
  result.sensor_id = scan.sensor_id;
  result.p_earth_sonar = {posed.T_earth_sonar.north, posed.T_earth_sonar.east};
  result.clutter_grid = [this] { return clutter_grid(); };
  if (estimator_) {
    result.method = estimator_->method();
    result.window_scans = estimator_->window_scans();
    result.sensor_estimate = estimator_->sensor_estimate();
  }
  if (!result.sensor_estimate) result.sensor_estimate = tracker_->sensor_estimate();
  return result;
}

std::optional<core::ClutterGrid> ScanPipeline::clutter_grid() const {
  auto grid = tracker_->clutter_grid();
  if (!grid) return grid;
  grid->utime += latency_;
  grid->sensor_id = sensor_id_;
  return grid;
}

void ScanPipeline::explain_to(const DecisionLog& log) {
  if (!log || latency_ == 0) return tracker_->explain_to(log);
  tracker_->explain_to([log, latency = latency_](TrackDecision decision) {
    decision.utime += latency;
    log(decision);
  });
}

// The newest that the tracker knows is `latency` old; beyond it tracks are moved on.
std::span<const core::Track> ScanPipeline::retrodict(std::int64_t utime) {
  if (latency_ == 0) return tracker_->retrodict(utime);
  const std::int64_t known = std::min(utime, scan_.scan.utime);
  return bring_to_scan(tracker_->retrodict(known), core::seconds(utime - known));
}

std::span<const core::Track> ScanPipeline::bring_to_scan(std::span<const core::Track> tracks,
                                                         double seconds) {
  if (latency_ == 0) return tracks;
  const Eigen::Matrix4d on = core::constant_velocity_transition(seconds);
  tracks_.assign(tracks.begin(), tracks.end());
  for (core::Track& track : tracks_) {
    track.state = on * track.state;
    track.covariance = on * track.covariance * on.transpose();
  }
  return tracks_;
}

std::span<const core::MotionElement> ScanPipeline::bring_to_scan(
    std::span<const core::MotionElement> elements) {
  if (latency_ == 0) return elements;
  const double seconds = core::seconds(latency_);
  const Eigen::Matrix4d on = core::constant_velocity_transition(seconds);
  elements_.assign(elements.begin(), elements.end());
  for (core::MotionElement& element : elements_) {
    element.position += seconds * element.velocity;
    element.covariance = on * element.covariance * on.transpose();
  }
  return elements_;
}

}  // namespace lookout::tracking
