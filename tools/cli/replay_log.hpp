#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/cli/tracked_run.hpp"

namespace lookout::tools {

/// What an LCM log held.
struct LogFigures {
  std::int64_t messages = 0;            ///< That could be read, of all channels.
  std::int64_t damages = 0;             ///< Stretches that could not.
  std::int64_t bytes_lost = 0;          ///< In them.
  std::int64_t bad_messages = 0;        ///< On our channels, undecodable or refused.
  std::int64_t pings = 0;               ///< Scans, or images where these are tracked.
  std::vector<core::TrackList> tracks;  ///< The TRACKS in the log.
};

/// Takes the messages of the log through the chain in the order of the log, as a tracker live would have: its
/// scans, or its images where the configuration's estimator tracks these.
/// @throws core::InputError where the file is no readable log.
TrackedRun replay_log(const std::string& path, const std::string& channel_prefix,
                      const Configuration& configuration, std::uint64_t seed, LogFigures& figures);

/// The first time [us] at which two runs' tracks differ in anything that tracks.csv holds; nothing where they
/// are equal as far as both go.
std::optional<std::int64_t> first_difference(const std::vector<core::TrackList>& a,
                                             const std::vector<core::TrackList>& b);

}  // namespace lookout::tools
