#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/frames.hpp"
#include "core/random.hpp"
#include "core/track.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout {

/// Scan `index` of the default sonar at the origin: ten beams that return a range in 60 to 90 m, twenty times
/// as dense as the background's returns, three in each scan.
inline core::PosedScan patch_scan(int index, core::Random& random) {
  std::vector<Eigen::Vector2d> points;
  for (int beam = 30; beam < 40; ++beam)
    points.push_back(core::from_polar(random.uniform(60.0, 90.0), core::radians(beam - 44.5)));
  for (int k = 0; k < 3; ++k)
    points.push_back(core::from_polar(random.uniform(10.0, 140.0), core::radians(random.uniform(0.0, 44.0))));
  return scan_of(index, points);
}

/// Mean number of confirmed tracks in the second half of 120 such scans. @param update takes a scan and gives
/// the tracks.
template <class Update>
double confirmed_in_patch(const Update& update) {
  constexpr int kScans = 120;
  core::Random random(11);
  double sum = 0.0;
  for (int k = 0; k < kScans; ++k) {
    const std::span<const core::Track> tracks = update(patch_scan(k, random));
    if (2 * k < kScans) continue;
    sum += static_cast<double>(std::count_if(tracks.begin(), tracks.end(), [](const core::Track& track) {
      return track.status == core::TrackStatus::confirmed;
    }));
  }
  return sum / (0.5 * kScans);
}

/// Of some six false tracks at a time that a tracker has there without its map, at most one is left.
template <class SomeTracker, class Params>
void expect_map_finds_patch() {
  const auto confirmed = [](bool enabled) {
    Params params;
    params.clutter.map.enabled = enabled;
    SomeTracker tracker(params, {});
    EXPECT_EQ(tracker.learns_clutter(), enabled);
    return confirmed_in_patch([&](const core::PosedScan& scan) { return tracker.update(scan, {}); });
  };
  EXPECT_GT(confirmed(false), 3.0);
  EXPECT_LT(confirmed(true), 1.0);
}

}  // namespace lookout
