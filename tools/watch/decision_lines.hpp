#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lookout::tools {

/// The newest of the lines that a tracker's --explain wrote to `path` about one track, oldest first, at most
/// 30; empty where the file cannot be read. Of a long file only the last megabyte is looked at.
std::vector<std::string> decision_lines(const std::string& path, std::int64_t track);

}  // namespace lookout::tools
