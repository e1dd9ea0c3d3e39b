#pragma once

#include <span>
#include <vector>

#include "core/track.hpp"
#include "tracking/joint_report.hpp"
#include "tracking/joint_state.hpp"

namespace lookout::tracking {

/// What the world is told: which tracks are confirmed, and all that are worth publishing.
class JointOutput {
 public:
  /// @param params validated. @param random of the target sets that `JointReport` draws.
  JointOutput(const JointReportParams& params, core::Random& random)
      : params_(params), report_(params, random) {}

  /// Chooses the tracks that are confirmed at the newest scan. @param unseen mean number of targets in view
  /// that no sure track stands for.
  void choose(double unseen, JointState& state);

  /// The tracks at the newest scan; valid until the next call.
  std::span<const core::Track> publish(JointState& state);

 private:
  double least_first_existence(const csht::ScanHistory& scans) const;
  void confirm(JointTrack& track, bool report, const JointState& state) const;
  void publish_track(const JointTrack& track);

  JointReportParams params_;
  JointReport report_;
  std::vector<ReportCandidate> candidates_;
  std::vector<core::Track> published_;
};

}  // namespace lookout::tracking
