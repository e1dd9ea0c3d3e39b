#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "csht/likelihood/clutter/local_clutter.hpp"
#include "csht/line_sample.hpp"

namespace lookout::csht {

/// A scan of the window.
struct WindowScan {
  std::int64_t utime = 0;     ///< [us].
  double time = 0.0;          ///< Since the window's anchor [s].
  core::Pose2 T_earth_sonar;  ///< Pose of the sonar.
  int first_detection = 0;    ///< Index of its first detection in `HoughWindow::detections()`.
  int num_detections = 0;     ///< How many detections it has; 0 of an empty scan.
};

/// A detection of the window with the accuracy of its sensor.
struct WindowDetection {
  int scan = 0;                         ///< Index in `HoughWindow::scans()`.
  int beam = 0;                         ///< Beam that reported it.
  double time = 0.0;                    ///< Since the window's anchor [s].
  double range = 0.0;                   ///< [m].
  Eigen::Vector2d p_earth{0, 0};        ///< North, east [m].
  Eigen::Vector2d line_of_sight{1, 0};  ///< Unit vector from the sonar, north and east.
  double range_variance = 1.0;          ///< Along the line of sight [m^2].
  double cross_variance = 1.0;          ///< Across it [m^2].
  double background = 1.0;              ///< See LocalClutter::backgrounds.

  /// Squared distance of the earth-frame offset to the detection, in units of the error plus `slack` [m].
  double distance(const Eigen::Vector2d& offset, double slack = 0.0) const {
    const double along = offset.dot(line_of_sight);
    const double across = line_of_sight.x() * offset.y() - line_of_sight.y() * offset.x();
    const double extra = slack * slack;
    return along * along / (range_variance + extra) + across * across / (cross_variance + extra);
  }
};

/// ln of `background`: what the density of false returns adds to the log likelihood ratio of a target's own.
inline double log_background(const WindowDetection& detection) {
  return detection.background < 1.0 ? std::log(detection.background) : 0.0;
}

/// The latest W posed scans as detections in the earth frame with their accuracy. [Yan2018] Eq. (10).
/// Memory is kept: a warm window allocates nothing.
class HoughWindow {
 public:
  /// @param window_scans W, > 0.
  /// @param cross_floor standard deviation added across the line of sight [m], >= 0.
  HoughWindow(int window_scans, const core::SonarParams& sonar, double cross_floor);

  /// Takes the next scan, and forgets the oldest where the window is full. @param clutter has taken the scan,
  /// and those of the window before it, too: it says which returns are one echo and what each is worth. Null:
  /// all count alike.
  void add(const core::PosedScan& scan, const LocalClutter* clutter = nullptr);

  /// Whether the next scan pushes the oldest out.
  bool full() const { return static_cast<int>(scans_.size()) == window_scans_; }
  std::span<const WindowScan> scans() const { return scans_; }                 ///< The oldest first.
  std::span<const WindowDetection> detections() const { return detections_; }  ///< In the order of the scans.
  /// The line samples of axis 0 (north) or 1 (east), one a detection in the order of `detections()`.
  std::span<const LineSample> lines(int axis) const { return lines_[axis]; }
  /// The line samples of the scan that the last `add` forgot; empty where none was.
  std::span<const LineSample> forgotten_lines(int axis) const { return forgotten_[axis]; }
  /// The line samples of the newest scan.
  std::span<const LineSample> newest_lines(int axis) const;

  const core::SonarParams& sonar() const { return sonar_; }  ///< With the newest scan's geometry.
  double centre_time() const;                                ///< Middle of the window since the anchor [s].

 private:
  void forget_oldest();
  void take_newest(const core::PosedScan& scan, const LocalClutter* clutter);
  void price(const LocalClutter& clutter);
  WindowDetection with_accuracy(const core::Detection& detection, double time) const;

  int window_scans_;
  core::SonarParams sonar_;
  double cross_floor_;
  std::int64_t anchor_ = 0;
  bool anchored_ = false;
  std::int64_t scan_count_ = 0;
  std::vector<core::Detection> newest_;  ///< Of the scan that is added.
  std::vector<WindowScan> scans_;
  std::vector<WindowDetection> detections_;
  std::vector<LineSample> lines_[2];
  std::vector<LineSample> forgotten_[2];
};

}  // namespace lookout::csht
