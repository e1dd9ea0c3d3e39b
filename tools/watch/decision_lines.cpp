#include "tools/watch/decision_lines.hpp"

#include <fstream>

namespace lookout::tools {
namespace {

constexpr std::streamoff kLongestRead = 1'000'000;  // [bytes]
constexpr std::size_t kMostLines = 30;
constexpr std::size_t kLongestLine = 300;  // [characters]

}  // namespace

std::vector<std::string> decision_lines(const std::string& path, std::int64_t track) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) return {};
  file.seekg(size > kLongestRead ? size - kLongestRead : 0);
  const std::string mark = " track " + std::to_string(track) + ":";
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.find(mark) != std::string::npos) lines.push_back(line.substr(0, kLongestLine));
    if (lines.size() > kMostLines) lines.erase(lines.begin());
  }
  return lines;
}

}  // namespace lookout::tools
