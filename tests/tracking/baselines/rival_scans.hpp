#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/track.hpp"
#include "tests/support/sonar_scene.hpp"
#include "tracking/tracker.hpp"

/// Scans and sonars that the tests of the rivals share.
namespace lookout::tracking {

/// The default sonar with its figures given.
inline core::SonarParams known_sonar(double miss, double false_alarm) {
  core::SonarParams sonar;
  sonar.miss_probability = miss;
  sonar.false_alarm_probability = false_alarm;
  return sonar;
}

/// The tracks that are confirmed or coasting.
inline std::vector<core::Track> confirmed(std::span<const core::Track> tracks) {
  std::vector<core::Track> result;
  for (const auto& track : tracks)
    if (track.status != core::TrackStatus::tentative) result.push_back(track);
  return result;
}

/// Scan k of these targets, each seen with 1 - P_M, among some eight false alarms.
inline core::PosedScan cluttered(int k, const std::vector<Eigen::Vector2d>& targets, double miss,
                                 core::Random& random) {
  std::vector<Eigen::Vector2d> seen;
  for (const auto& target : targets)
    if (!random.bernoulli(miss)) seen.push_back(target);
  for (int left = random.poisson(8.0); left > 0; --left)
    seen.push_back(core::from_polar(random.uniform(1.0, 150.0), core::radians(random.uniform(-44.0, 44.0))));
  return scan_of(k, seen);
}

/// What stands after sixty scans of one target at 1 m/s from 50 m on, P_M .3, among false alarms.
inline std::vector<core::Track> tracks_through_clutter(Tracker& tracker) {
  core::Random random(5);
  std::span<const core::Track> tracks;
  for (int k = 0; k < 60; ++k)
    tracks = tracker.update(cluttered(k, {{50.0 + 0.5 * k, 0.0}}, 0.3, random), {});
  return confirmed(tracks);
}

/// Two targets cross at an angle; whether each keeps its identity and its direction.
inline bool crossing_targets_keep_their_identities(Tracker& tracker) {
  std::vector<core::Track> before, after;
  for (int k = 0; k < 80; ++k) {
    const double east = -20.0 + 0.5 * k;
    after = confirmed(tracker.update(scan_of(k, {{60.0 + 0.3 * k, east}, {84.0 - 0.3 * k, east}}), {}));
    if (k == 25) before = after;
  }
  if (before.size() != 2 || after.size() != 2) return false;
  for (std::size_t i = 0; i < 2; ++i)
    if (before[i].id != after[i].id || before[i].state(2) * after[i].state(2) <= 0.0) return false;
  return true;
}

}  // namespace lookout::tracking
