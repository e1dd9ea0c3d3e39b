#include "tools/cli/logs/log_survey.hpp"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/input_error.hpp"
#include "lcmtypes/log_reader.hpp"

namespace lookout::tools {
namespace {

constexpr std::size_t kMostNamed = 20;  ///< Channels in one line.
constexpr std::size_t kLook = 40;       ///< Bytes of a foreign file that are shown.
constexpr const char* kExpected =
    "expected an LCM log (lcm-logger writes one) or the directory of a recording";

/// Also for a path that no file can have.
bool is_there(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

std::string part_of(const std::string& path, int number) {
  char suffix[16];
  std::snprintf(suffix, sizeof suffix, ".%02d", number);
  return path + suffix;
}

/// Text of a channel or a file's beginning that is safe on a terminal.
std::string printable(std::string text) {
  for (char& letter : text) {
    if (std::isprint(static_cast<unsigned char>(letter)) == 0) letter = '?';
  }
  return text;
}

/// Why a file without a single event is none of ours.
std::string look_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(kLook, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (begin.empty()) return "is empty";
  for (const char letter : begin) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isprint(code) == 0 && std::isspace(code) == 0) return "is no LCM log";
  }
  return "is text, no LCM log: it begins with `" + printable(begin.substr(0, begin.find_first_of("\r\n"))) +
         "`";
}

}  // namespace

std::string LogSurvey::names() const {
  std::string line;
  std::size_t named = 0;
  for (const auto& [channel, count] : channels) {
    if (named++ == kMostNamed) return line + ", ...";
    line += (line.empty() ? "" : ", ") + printable(channel) + " (" + std::to_string(count) + ")";
  }
  return line;
}

std::vector<std::string> log_files(const std::vector<std::string>& inputs) {
  std::vector<std::string> files;
  for (const auto& input : inputs) {
    if (is_there(input) || !is_there(part_of(input, 0))) {
      files.push_back(input);
      continue;
    }
    for (int number = 0; is_there(part_of(input, number)); ++number) files.push_back(part_of(input, number));
  }
  return files;
}

LogSurvey survey_log(const std::vector<std::string>& files) {
  LogSurvey survey;
  for (const auto& file : files) {
    lcmtypes::LogReader log(file);
    while (const auto message = log.next()) ++survey.channels[message->channel];
    if (log.messages() == 0) throw core::InputError(file + ": " + look_of(file) + "; " + kExpected);
    survey.messages += log.messages();
    survey.damages += log.damages();
    survey.bytes_lost += log.bytes_lost();
  }
  return survey;
}

}  // namespace lookout::tools
