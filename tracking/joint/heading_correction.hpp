#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csht/likelihood/scan_history.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Estimates the error of a scan's heading, which all its targets share, before the tracks are updated: each
/// heading of a grid has as its weight its prior times the likelihood of the scan, if that were the heading
/// and the tracks were where they are predicted. docs/joint_tracker.md.
class HeadingCorrection {
 public:
  /// @param params validated.
  explicit HeadingCorrection(const HeadingParams& params) : params_(params) {}

  /// Turns the newest scan to the heading that `find` gives, if it gives one.
  void refine(TrackerState& state);

  /// Mean and standard deviation of the heading's error [rad], from the tracks as predicted to the newest
  /// scan; nothing where the heading is exact, the sensor has no beams, or fewer than two tracks are sure
  /// enough.
  std::optional<csht::HeadingError> find(std::span<const csht::TargetTrack> tracks,
                                         const csht::ScanHistory& scans);

 private:
  bool tells(const csht::TargetTrack& track) const;
  double log_likelihood(std::span<const csht::TargetTrack> tracks);
  csht::HeadingError moments(double step);

  HeadingParams params_;
  csht::ScanTable table_;  ///< The newest scan, turned to one heading of the grid after another.
  std::vector<double> log_weight_, weight_, ratio_;
};

}  // namespace lookout::tracking
