#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lookout::tools {

/// What lies in the files of an LCM log, before anything of it is decoded.
struct LogSurvey {
  std::map<std::string, std::int64_t> channels;  ///< Messages of each.
  std::int64_t messages = 0;
  std::int64_t damages = 0;     ///< Stretches that could not be read.
  std::int64_t bytes_lost = 0;  ///< In them.

  /// "SONAR_SCAN (60), VEHICLE_STATE (61)"; the first of very many.
  std::string names() const;
};

/// The files that a person means: those that are there, and for a log that the logger split into `dive.00`,
/// `dive.01` and so on, and whose own name is given, its parts in order.
std::vector<std::string> log_files(const std::vector<std::string>& inputs);

/// @throws core::InputError where a file cannot be read, is empty, or holds no message of an LCM log: what it
/// looks like, and what is expected.
LogSurvey survey_log(const std::vector<std::string>& files);

}  // namespace lookout::tools
