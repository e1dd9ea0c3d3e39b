#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lcmtypes/inbox.hpp"
#include "tools/cli/images/found_returns.hpp"
#include "tools/cli/logs/log_survey.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tracking/intake/stamp_clock.hpp"

namespace lookout::tools {

/// What an LCM log held.
struct LogFigures {
  LogSurvey survey;
  std::vector<lcmtypes::Refusal> refusals;  ///< Messages on our channels that were not taken, by reason.
  std::int64_t pings = 0;                   ///< Scans, or images where these are tracked.
  std::int64_t refused_truth = 0;           ///< Lists of a time that had one already.
  std::int64_t images_left_out = 0;         ///< Of the recording: they go back in time, or repeat it.
  tracking::StampClock stamps;              ///< Of those pings, against the log's own clock.
  bool is_fixed = false;                    ///< No vehicle state in it: a fixed sensor at the origin.
  std::vector<core::TrackList> tracks;      ///< The TRACKS in the log.
};

/// What a person should know of a log beside what it holds: a line for each kind of message that was not used
/// or is read in a way of its own.
std::vector<std::string> notes_of(const LogFigures& figures, const core::Recording& recording);

/// Takes the messages of a log's files through the chain in the order of the log, as a tracker live would
/// have: its scans, or its images where the configuration's estimator tracks these.
/// @param images_out recording directory that the images are written to; empty: none.
/// @throws core::InputError where a file is no readable log, or holds nothing to track: what is there, and
/// why it was refused.
TrackedRun replay_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                      const Configuration& configuration, std::uint64_t seed, LogFigures& figures,
                      const std::string& images_out = {});

/// The scans, vehicle states and truth of a log's files as `Recorder` keeps them, tracked by nobody; images
/// are left. @param sensor what is known of it beside the geometry of its scans.
/// @throws core::InputError as `replay_log`.
core::Recording read_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                         const core::SonarParams& sensor, LogFigures& figures);

/// Takes the images of a log's files through detection. @return the scans with the log's vehicle states and
/// truth, as `Recorder` keeps them. @throws core::InputError as `replay_log`.
core::Recording detect_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                           FoundReturns& found);

/// The first time [us] at which two runs' tracks differ in anything that tracks.csv holds; nothing where they
/// are equal as far as both go.
std::optional<std::int64_t> first_difference(const std::vector<core::TrackList>& a,
                                             const std::vector<core::TrackList>& b);

}  // namespace lookout::tools
