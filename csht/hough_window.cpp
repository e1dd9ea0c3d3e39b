#include "csht/hough_window.hpp"

#include <cmath>

#include "core/field_of_view.hpp"
#include "core/parameter_check.hpp"
#include "csht/scan_to_detections.hpp"

namespace lookout::csht {

HoughWindow::HoughWindow(int window_scans, const core::SonarParams& sonar, double cross_floor)
    : window_scans_(window_scans), sonar_(sonar), cross_floor_(cross_floor) {
  core::require(window_scans >= 1, "window_scans must be > 0", window_scans);
  core::require_not_negative("cross_floor", cross_floor);
  const auto returns = static_cast<std::size_t>(sonar.num_beams);
  scans_.reserve(static_cast<std::size_t>(window_scans));
  detections_.reserve(returns * static_cast<std::size_t>(window_scans));
  newest_.reserve(returns);
  for (auto& line : lines_) line.reserve(detections_.capacity());
  for (auto& line : forgotten_) line.reserve(returns);
}

void HoughWindow::add(const core::PosedScan& posed, const LocalClutter* clutter) {
  if (!anchored_) anchor_ = posed.scan.utime;
  anchored_ = true;
  for (auto& line : forgotten_) line.clear();
  if (full()) forget_oldest();
  sonar_ = core::with_geometry_of(posed.scan, sonar_);
  take_newest(posed, clutter);
  const double time = core::seconds(posed.scan.utime - anchor_);
  scans_.push_back({posed.scan.utime, time, posed.T_earth_sonar, static_cast<int>(detections_.size()),
                    static_cast<int>(newest_.size())});
  for (std::size_t j = 0; j < newest_.size(); ++j) {
    const WindowDetection own = with_accuracy(newest_[j], time);
    const double weight = clutter != nullptr ? clutter->worth()[j].weight : 1.0;
    detections_.push_back(own);
    for (int axis = 0; axis < 2; ++axis) {
      const double along = own.line_of_sight[axis], across = own.line_of_sight[1 - axis];
      const double sigma =
          std::sqrt(along * along * own.range_variance + across * across * own.cross_variance);
      lines_[axis].push_back({scan_count_, time, own.p_earth[axis], sigma, weight});
    }
  }
  ++scan_count_;
  if (clutter != nullptr) price(*clutter);
}

void HoughWindow::take_newest(const core::PosedScan& scan, const LocalClutter* clutter) {
  const int index = static_cast<int>(scans_.size());
  if (clutter == nullptr) {
    scan_to_detections(scan, index, newest_);
    return;
  }
  newest_.assign(clutter->detections().begin(), clutter->detections().end());
  for (auto& detection : newest_) detection.scan = index;
}

// Of all scans of the window the map knows more by now.
void HoughWindow::price(const LocalClutter& clutter) {
  for (std::size_t s = 0; s < scans_.size(); ++s) {
    const auto background = clutter.backgrounds(static_cast<int>(scans_.size() - 1 - s));
    if (background.size() != static_cast<std::size_t>(scans_[s].num_detections)) continue;
    for (std::size_t j = 0; j < background.size(); ++j)
      detections_[static_cast<std::size_t>(scans_[s].first_detection) + j].background = background[j];
  }
}

void HoughWindow::forget_oldest() {
  const int gone = scans_.front().num_detections;
  for (int axis = 0; axis < 2; ++axis) {
    forgotten_[axis].assign(lines_[axis].begin(), lines_[axis].begin() + gone);
    lines_[axis].erase(lines_[axis].begin(), lines_[axis].begin() + gone);
  }
  detections_.erase(detections_.begin(), detections_.begin() + gone);
  scans_.erase(scans_.begin());
  for (auto& scan : scans_) scan.first_detection -= gone;
  for (auto& detection : detections_) --detection.scan;
}

WindowDetection HoughWindow::with_accuracy(const core::Detection& detection, double time) const {
  const double cross = detection.range * sonar_.bearing_sigma_at(detection.beam);
  WindowDetection result;
  result.scan = detection.scan;
  result.beam = detection.beam;
  result.time = time;
  result.range = detection.range;
  result.p_earth = detection.p_earth;
  result.line_of_sight = {std::cos(detection.azimuth), std::sin(detection.azimuth)};
  result.range_variance = sonar_.range_sigma * sonar_.range_sigma;
  result.cross_variance = cross * cross + cross_floor_ * cross_floor_;
  return result;
}

std::span<const LineSample> HoughWindow::newest_lines(int axis) const {
  if (scans_.empty()) return {};
  return lines(axis).last(static_cast<std::size_t>(scans_.back().num_detections));
}

double HoughWindow::centre_time() const {
  return scans_.empty() ? 0.0 : 0.5 * (scans_.front().time + scans_.back().time);
}

}  // namespace lookout::csht
