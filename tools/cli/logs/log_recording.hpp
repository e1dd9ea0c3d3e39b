#pragma once

#include <string>
#include <vector>

#include "core/files/recording.hpp"

namespace lookout::tools {

/// Writes a recording as the LCM log that a vehicle would have kept: VEHICLE_STATE and SONAR_SCAN in the
/// order of their times, GROUND_TRUTH behind the scan that it belongs to, then TRACKS. Each message counts as
/// recorded at its own time. Of a fixed sensor there are no vehicle states.
/// @param tracks lists of tracks by scan, in order of time; their sequence is that of the scan; may be empty.
/// @param channel_prefix of the vehicle's channels.
/// @throws core::InputError where the file cannot be created, the prefix is none, or a list of tracks belongs
/// to no scan; std::length_error on a scan or list that no message holds; std::runtime_error where the disk
/// refuses.
void write_log(const std::string& path, const core::Recording& recording,
               const std::vector<core::TrackList>& tracks, const std::string& channel_prefix);

}  // namespace lookout::tools
