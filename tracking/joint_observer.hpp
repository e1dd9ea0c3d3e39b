#pragma once

#include <cstddef>
#include <vector>

#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_track.hpp"

namespace lookout::tracking {

/// Where a track is as the sonar sees it: in which beams, whether in view, and whether an echo may be its
/// own; and from that, what it claims of the scans.
class JointObserver {
 public:
  /// @param params validated.
  explicit JointObserver(const JointObserverParams& params = {}) : params_(params) {}

  /// Notes visibility and echo of the newest scan in `track`; with `claim`, its claims on it.
  void observe(int slot, JointTrack& track, bool claim, JointLikelihood& likelihood);

  /// The claims of `cloud` on the newest scan alone.
  void claim(int slot, const JointCloud& cloud, JointLikelihood& likelihood) {
    look(slot, cloud, 0, true, 1, likelihood);
  }

  /// Notes the existence of `track`, observes it and, where it is sure enough for that, renews its claims on
  /// the scans that it remembers.
  void claim_memory(int slot, JointTrack& track, const AgeSpan& memory, JointLikelihood& likelihood);

  /// Claims on the scans of ages 1 .. oldest, from the present cloud, in place of those before.
  void claim_past(int slot, JointTrack& track, int oldest, JointLikelihood& likelihood);

 private:
  struct View {
    double visible = 0.0;
    double echo = 0.0;
  };
  View look(int slot, const JointCloud& cloud, int age, bool claim, std::size_t stride,
            JointLikelihood& likelihood);
  View look_beams(const JointCloud& cloud, const csht::ScanTable& scan, double seconds, std::size_t stride);
  View look_blurred(const JointCloud& cloud, const csht::ScanTable& scan, double seconds, std::size_t stride);
  View look_points(const JointCloud& cloud, const csht::ScanTable& scan, const csht::SensorFigures& figures,
                   double seconds, std::size_t stride);

  JointObserverParams params_;
  std::vector<double> share_, range_;  ///< By beam, or by detection of a point sensor.
  std::vector<int> touched_;
  std::vector<double> ratio_;
};

}  // namespace lookout::tracking
