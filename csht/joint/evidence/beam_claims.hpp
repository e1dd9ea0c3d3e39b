#pragma once

#include <cstddef>
#include <vector>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// Where a track is as the sonar sees it: in which beams, whether in view, and whether an echo may be its
/// own; and from that, what it claims of the scans.
class BeamClaims {
 public:
  /// @param params validated.
  explicit BeamClaims(const BeamClaimParams& params = {}) : params_(params) {}

  /// Notes visibility and echo of the newest scan in `track`; with `claim`, its claims on it.
  void observe(int slot, TargetTrack& track, bool claim, ScanLikelihood& likelihood);

  /// The claims of `cloud` on the newest scan alone.
  void claim(int slot, const TrajectoryCloud& cloud, ScanLikelihood& likelihood) {
    look(slot, cloud, 0, true, 1, likelihood);
  }

  /// Notes the existence of `track`, observes it and, where it is sure enough for that, renews its claims on
  /// the scans that it remembers.
  void claim_memory(int slot, TargetTrack& track, const AgeSpan& memory, ScanLikelihood& likelihood);

  /// Claims on the scans of ages 1 .. oldest, from the present cloud, in place of those before.
  void claim_past(int slot, TargetTrack& track, int oldest, ScanLikelihood& likelihood);

 private:
  struct View {
    double visible = 0.0;
    double echo = 0.0;
  };
  View look(int slot, const TrajectoryCloud& cloud, int age, bool claim, std::size_t stride,
            ScanLikelihood& likelihood);
  View look_beams(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds, std::size_t stride);
  View look_blurred(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds, std::size_t stride);
  View look_points(const TrajectoryCloud& cloud, const ScanTable& scan, const SensorFigures& figures,
                   double seconds, std::size_t stride);

  BeamClaimParams params_;
  std::vector<double> share_, range_;  ///< By beam, or by detection of a point sensor.
  std::vector<int> touched_;
  std::vector<double> ratio_;
};

}  // namespace lookout::csht
