#pragma once

#include <cmath>

#include "tests/support/sonar_scene.hpp"
#include "tracking/joint/births.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// A sonar with both probabilities at 0.1.
inline core::SonarParams clear_sonar() {
  core::SonarParams sonar;
  sonar.miss_probability = 0.1;
  sonar.false_alarm_probability = 0.1;
  return sonar;
}

/// `count` scans of a target that moves north at 1 m/s, at `start` in the first.
inline void push_target(TrackerState& state, int count, const Eigen::Vector2d& start = {60.0, 10.0}) {
  for (int k = 0; k < count; ++k) state.likelihood.push(scan_of(k, {start + Eigen::Vector2d(0.5 * k, 0.0)}));
}

/// A track in a slot of its own whose cloud is one trajectory at constant velocity, with these log odds.
inline csht::TargetTrack& add_track(TrackerState& state, const Eigen::Vector4d& line, double log_odds) {
  csht::TargetTrack& track = *state.free_track();
  track.cloud = csht::TrajectoryCloud();
  track.cloud.resize(1);
  track.cloud.north[0] = line[0];
  track.cloud.east[0] = line[1];
  track.cloud.north_velocity[0] = line[2];
  track.cloud.east_velocity[0] = line[3];
  track.cloud.weight[0] = 1.0;
  track.begin({log_odds, 0.0, state.scans().pushed() - 1, state.now(), state.now()});
  return track;
}

}  // namespace lookout::tracking
