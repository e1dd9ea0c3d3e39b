#pragma once

#include <cstddef>
#include <vector>

#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// Where the sonar has a track: in which beams with what probability, whether in view at all, and whether a
/// detection may be its own. From that follows what the track claims of the scans.
class BeamClaims {
 public:
  /// @param params validated.
  explicit BeamClaims(const BeamClaimParams& params = {}) : params_(params) {}

  /// Notes in `track` the probabilities that it is in view of the newest scan and that a detection there is
  /// its own. With `claim`, also adds its claims on that scan. @param slot of the track.
  void observe(int slot, TargetTrack& track, bool claim, ScanLikelihood& likelihood);

  /// Adds what `cloud` claims of the newest scan, as claims of the track in `slot`.
  void claim(int slot, const TrajectoryCloud& cloud, ScanLikelihood& likelihood) {
    look(slot, cloud, 0, true, 1, likelihood);
  }

  /// Notes the existence of `track` and observes it. Where it exists probably enough, its claims on the scans
  /// that it remembers are made anew, unless they were made with the present cloud.
  void claim_memory(int slot, TargetTrack& track, const AgeSpan& memory, ScanLikelihood& likelihood);

  /// Replaces its claims on the scans of ages 1 to `oldest` by those of its present cloud.
  void claim_past(int slot, TargetTrack& track, int oldest, ScanLikelihood& likelihood);

 private:
  struct View {
    double visible = 0.0;   // Probability that it is in view,
    double detected = 0.0;  // and that a detection of the scan is its own.
  };
  View look(int slot, const TrajectoryCloud& cloud, int age, bool claim, std::size_t stride,
            ScanLikelihood& likelihood);
  View look_beams(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds, std::size_t stride);
  View look_blurred(const TrajectoryCloud& cloud, const ScanTable& scan, double seconds, std::size_t stride);
  View look_points(const TrajectoryCloud& cloud, int age, std::size_t stride,
                   const ScanLikelihood& likelihood);

  BeamClaimParams params_;
  std::vector<double> share_, range_;  ///< By beam, or by detection of a point sensor.
  std::vector<int> touched_;           ///< Indices of `share_` that are not zero.
  std::vector<double> ratio_;
};

}  // namespace lookout::csht
