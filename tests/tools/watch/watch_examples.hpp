#pragma once

#include <chrono>
#include <lookout/node_status_t.hpp>
#include <string>
#include <vector>

#include "tests/lcmtypes/example_messages.hpp"
#include "tools/watch/heard.hpp"

/// Messages as they come from a link, for the tests of what is shown of them.
namespace lookout::tools {

inline Heard::Clock::time_point at_second(double seconds) {
  return Heard::Clock::time_point(
      std::chrono::duration_cast<Heard::Clock::duration>(std::chrono::duration<double>(seconds)));
}

template <class Wire>
void say(Heard& heard, const std::string& channel, const Wire& wire, double second = 0.0) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  heard.take(channel, bytes, at_second(second));
}

inline node_status_t tracker_status(std::int64_t rejected = 0) {
  node_status_t wire{};
  wire.node_id = 1;
  wire.accepted = 5;
  wire.rejected = rejected;
  wire.latency_ms_p99 = 12.5;
  wire.node = "lookout track";
  return wire;
}

/// A scan each half second with the states around it, the tracks of it, and a status each second.
inline void say_healthy(Heard& heard, int scans) {
  for (int k = 0; k < scans; ++k) {
    const double second = 0.5 * k;
    core::SonarScan scan = tests::example_scan();
    scan.utime = std::int64_t{500'000} * k;
    scan.sequence = k;
    core::VehicleState state{scan.utime, {10.0, 20.0, 0.0}, {1.0, 0.0}};
    core::Track track = tests::example_track(7);
    track.status = core::TrackStatus::confirmed;
    say(heard, "VEHICLE_STATE", lcmtypes::to_wire(state), second);
    say(heard, "SONAR_SCAN", lcmtypes::to_wire(scan), second);
    say(heard, "TRACKS", lcmtypes::to_wire({scan.utime, k, 0}, std::span(&track, 1)).message, second);
    if (k % 2 == 0) say(heard, "LOOKOUT_STATUS", tracker_status(), second);
  }
}

}  // namespace lookout::tools
