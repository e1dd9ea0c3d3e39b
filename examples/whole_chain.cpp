// The whole chain in a program of one's own: vehicle states and scans in, tracks out, after every scan.
// Built against the installed package: find_package(lookout), target_link_libraries(... lookout::tracking).
#include <cstdio>

#include "tracking/tracking_chain.hpp"

using namespace lookout;

// One beam dead ahead returns a target at 40 m; the vehicle drives north at 1 m/s. Angles in radians.
core::SonarScan ping(std::int64_t utime) {
  return {.utime = utime,
          .sequence = utime / 1'000'000,
          .first_bearing = -0.5,
          .bearing_step = 0.1,
          .max_range = 90.0,
          .num_beams = 11,
          .returns = {{.bearing = 0.0, .range = 40.0}}};
}

core::VehicleState state(std::int64_t utime) {
  return {utime, core::Pose2{1e-6 * static_cast<double>(utime), 0.0, 0.0}, {1.0, 0.0}};
}

int main() {
  int scans = 0;
  const auto on_result = [&scans](const tracking::PingResult& result) {
    ++scans;
    for (const auto& track : result.tracks)
      std::printf("scan %d track %d: north %.1f m, east %.1f m\n", scans, static_cast<int>(track.id),
                  track.state[0], track.state[1]);
  };
  tracking::TrackingChain chain({}, on_result);
  for (std::int64_t utime = 0; utime < 20'000'000; utime += 1'000'000) {
    chain.add(state(utime));
    chain.add(ping(utime));
  }
  chain.finish();
  return scans == 20 ? 0 : 1;
}
