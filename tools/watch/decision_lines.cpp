#include "tools/watch/decision_lines.hpp"

#include <charconv>
#include <deque>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace lookout::tools {
namespace {

constexpr std::size_t kLongestLine = 300;  // [characters]

/// @param mark where " s track ID:" stands in it, behind the time.
DecisionLine line_of(const std::string& line, std::size_t mark) {
  const auto blank = line.find_last_of(' ', mark - 1);
  const std::size_t begin = mark == 0 || blank == std::string::npos ? 0 : blank + 1;
  DecisionLine decision;
  decision.text = line.substr(begin, kLongestLine);
  double time = 0.0;
  const auto [end, error] = std::from_chars(line.data() + begin, line.data() + mark, time);
  if (error == std::errc() && end == line.data() + mark) decision.time_s = time;
  return decision;
}

}  // namespace

std::optional<std::pair<std::int64_t, DecisionLine>> parse_decision(const std::string& line) {
  constexpr std::string_view kMark = " s track ";
  const auto mark = line.find(kMark);
  if (mark == std::string::npos) return std::nullopt;
  std::int64_t track = 0;
  const char* const last = line.data() + line.size();
  const auto [end, error] = std::from_chars(line.data() + mark + kMark.size(), last, track);
  if (error != std::errc() || end == last || *end != ':') return std::nullopt;
  return std::pair{track, line_of(line, mark)};
}

std::vector<DecisionLine> decision_lines(const std::string& path, std::int64_t track,
                                         std::int64_t longest_read) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};  // To open a pipe is to wait for it.
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) return {};
  file.seekg(size > longest_read ? size - longest_read : 0);
  const std::string mark = " s track " + std::to_string(track) + ":";
  std::deque<DecisionLine> lines;
  for (std::string line; std::getline(file, line);) {
    if (const auto at = line.find(mark); at != std::string::npos) lines.push_back(line_of(line, at));
    if (lines.size() > kMostDecisionLines) lines.pop_front();
  }
  return {lines.begin(), lines.end()};
}

}  // namespace lookout::tools
