#pragma once

#include <string>
#include <vector>

#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// When a chain counts as ill.
struct HealthLimits {
  double longest_silence = 5.0;      ///< Of scans, vehicle states and TRACKS [s]; slower scans get 3 periods.
  double longest_status_gap = 3.0;   ///< Of a tracker's LOOKOUT_STATUS, which comes every second [s].
  double largest_lost_share = 0.01;  ///< Of the pings, on their way to us.
};

/// What is wrong with the chain, a line each for a person, the gravest first; empty where it is healthy.
std::vector<std::string> complaints(const Heard& heard, Heard::Clock::time_point now,
                                    const HealthLimits& limits = {});

}  // namespace lookout::tools
