#pragma once

#include <span>
#include <vector>

#include "core/track.hpp"
#include "tracking/joint/expected_ospa.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Chooses which tracks are confirmed, and makes the list of tracks that is published.
class Confirmation {
 public:
  /// @param params validated. @param random of the target sets that `ExpectedOspa` draws.
  Confirmation(const ReportParams& params, core::Random& random) : params_(params), report_(params, random) {}

  /// Chooses the tracks that are confirmed at the newest scan. @param undetected mean number of targets in
  /// view that no track stands for whose existence is more probable than not.
  void choose(double undetected, TrackerState& state);

  /// The tracks at the newest scan; valid until the next call.
  std::span<const core::Track> publish(TrackerState& state);

 private:
  double least_first_existence(const csht::ScanHistory& scans) const;
  void confirm(csht::TargetTrack& track, bool report, const TrackerState& state) const;
  void publish_track(const csht::TargetTrack& track, double moving);
  double moving(const csht::TargetTrack& track, const TrackerState& state) const;

  ReportParams params_;
  ExpectedOspa report_;
  std::vector<ReportCandidate> candidates_;
  std::vector<core::Track> published_;
};

}  // namespace lookout::tracking
