#include "tracking/detection_chain.hpp"

#include <utility>

#include "tracking/intake/intake_words.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {

core::SonarParams with_figures(const core::SonarParams& given, const GivenFigures& which,
                               const ImageDetector& detector) {
  const core::SonarParams told = detector.sensor_figures(given);
  core::SonarParams params = given;
  if (!which.clutter) {
    params.false_alarm_probability.reset();
    params.clutter_per_scan = told.clutter_per_scan;
  }
  if (!which.range_sigma) params.range_sigma = told.range_sigma;
  if (!which.bearing_sigma) params.bearing_sigma = told.bearing_sigma;
  if (!which.resolution) params.resolution = told.resolution;
  return params;
}

StreamDetector::StreamDetector(const DetectionParams& params, Report report)
    : params_(params), report_(std::move(report)) {
  check(params);
}

const core::SonarScan* StreamDetector::detect(const core::SonarImage& image) {
  std::string_view reason = defect(image);
  if (reason.empty() && detectors_.size() >= kMostSonars && !detectors_.contains(image.sensor_id))
    reason = "more sonars than 64 on one vehicle";
  if (!reason.empty()) {
    if (worth_a_line(++damaged_))
      report_("image " + std::to_string(image.sequence) + " rejected: " + std::string(reason) +
              so_far(damaged_));
    return nullptr;
  }
  const auto found = detectors_.try_emplace(image.sensor_id, params_).first;
  latest_ = &found->second;
  return &latest_->detect(image);
}

DetectionCounts StreamDetector::counts() const {
  DetectionCounts sum;
  for (const auto& [id, detector] : detectors_) {
    sum.images += detector.counts().images;
    sum.returns += detector.counts().returns;
    sum.left_out += detector.counts().left_out;
  }
  return sum;
}

DetectionChain::DetectionChain(const DetectionParams& detection, const ChainParams& params,
                               const GivenFigures& which, OnResult on_result, Report report, OnScan on_scan)
    : sensor_(params.sensor),
      which_(which),
      on_scan_(std::move(on_scan)),
      detector_(detection, report),
      chain_(params, std::move(on_result), std::move(report)) {}

void DetectionChain::add(const core::VehicleState& state) {
  chain_.add(state);
  count();
}

void DetectionChain::add(const core::SonarImage& image) {
  if (const core::SonarScan* scan = detector_.detect(image)) {
    if (std::exchange(is_first_, false)) {
      sensor_ = with_figures(sensor_, which_, detector_.detector());
      chain_.use(sensor_);
    }
    if (on_scan_) on_scan_(*scan);
    chain_.add(*scan);
  }
  count();
}

void DetectionChain::shed(const core::SonarImage& image) {
  core::SonarScan scan;  // Without returns: a scan that is shed is only counted.
  scan.utime = image.utime;
  scan.sequence = image.sequence;
  scan.sensor_id = image.sensor_id;
  chain_.shed(scan);
  count();
}

void DetectionChain::finish() {
  chain_.finish();
  count();
}

void DetectionChain::start_new_clock() {
  chain_.start_new_clock();
}

void DetectionChain::count() {
  counts_ = chain_.counts();
  counts_.received += detector_.damaged();
  counts_.damaged += detector_.damaged();
}

}  // namespace lookout::tracking
