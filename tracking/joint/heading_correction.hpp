#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csht/likelihood/scan_history.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// The error of a scan's heading is one for all its targets: where navigation states headings with an error,
/// the tracks tell which, before the scan is taken in. Each heading of a grid is weighed with its prior and
/// with the likelihood of the scan under it, the tracks being where they are predicted to be.
/// docs/joint_tracker.md.
class HeadingCorrection {
 public:
  explicit HeadingCorrection(const HeadingParams& params) : params_(params) {}

  /// Turns the newest scan to the heading that the tracks, predicted to its time, make of it.
  void refine(TrackerState& state);

  /// What the tracks make of the heading of the newest scan; nothing where it is exact, the sensor has no
  /// beams, or fewer than two tracks tell.
  std::optional<csht::HeadingError> find(std::span<const csht::TargetTrack> tracks,
                                         const csht::ScanHistory& scans);

 private:
  bool tells(const csht::TargetTrack& track) const;
  double log_likelihood(std::span<const csht::TargetTrack> tracks);
  csht::HeadingError moments(double step);

  HeadingParams params_;
  csht::ScanTable table_;  ///< The scan as a likelihood without an error of the heading.
  std::vector<double> log_weight_, weight_, ratio_;
};

}  // namespace lookout::tracking
