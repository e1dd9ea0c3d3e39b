#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/experiment.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"

namespace lookout::tools {

/// How well targets of sonar images are held: sums over the pings of one run. A target is held where the
/// assignment of confirmed tracks to visible targets with the least squared distances gives it one within 5
/// m.
struct SonarScore {
  int pings = 0;                     ///< Of the run.
  int target_pings = 0;              ///< Visible targets, summed over the pings.
  int held = 0;                      ///< Of these, with a confirmed track.
  int false_tracks = 0;              ///< Confirmed tracks without a target, summed over the pings.
  double squared_error = 0.0;        ///< Of the positions of held targets [m^2].
  double nees = 0.0;                 ///< Of these positions, over the dimension, 2.
  double nees_state = 0.0;           ///< Of position and velocity, over the dimension, 4.
  double update_ms = 0.0;            ///< Processor time of the tracker.
  std::map<int, double> first_held;  ///< Target id -> time of its first confirmed track [s].

  /// Takes the tracks of one ping.
  void add(const core::GroundTruth& truth, std::span<const core::Track> tracks);
  /// Share in track, RMSE, NEES, false tracks a scan and a run, time to confirm and time a ping; metrics
  /// without a case are left out.
  Metrics metrics() const;
};

/// The scene of the sonar-image experiments, tools/scenarios/sonar_image.yaml, at a level and background.
/// @param p "snr_db", and where it has them "shape" (of the K-distributed background, else 4) and "situation"
/// ("empty": without targets).
sonar_sim::Scene sonar_scene(const Parameters& p);

/// What is known of that scene's instrument: its signature where `known`, else nothing.
tracking::InstrumentParams sonar_instrument(bool known);

/// One run of a scene through a tracker.
SonarScore score_run(tracking::ImageTracker& tracker, const sonar_sim::Scene& scene, std::uint64_t seed,
                     int run);

}  // namespace lookout::tools
