#pragma once

#include <cstddef>

#include "core/files/recording.hpp"

namespace lookout::tools {

/// Takes the vehicle states and scans of a recording to a chain in the order of their times, of one time the
/// state first, clock by clock.
/// @param chain with add(core::VehicleState), add(core::SonarScan) and start_new_clock().
template <class Chain>
void feed_scans(Chain& chain, const core::Recording& recording) {
  std::size_t scan = 0, state = 0;
  for (std::size_t clock = 0; clock <= recording.new_clocks.size(); ++clock) {
    if (clock > 0) chain.start_new_clock();
    const bool is_last = clock == recording.new_clocks.size();
    const std::size_t scans = is_last ? recording.scans.size() : recording.new_clocks[clock].scan;
    const std::size_t states = is_last ? recording.vehicle.size() : recording.new_clocks[clock].state;
    for (; scan < scans; ++scan) {
      while (state < states && recording.vehicle[state].utime <= recording.scans[scan].utime)
        chain.add(recording.vehicle[state++]);
      chain.add(recording.scans[scan]);
    }
    while (state < states) chain.add(recording.vehicle[state++]);
  }
}

}  // namespace lookout::tools
