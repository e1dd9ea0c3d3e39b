#pragma once

#include <string>

#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// One screen of text, at most 80 columns and 24 lines: health with its reasons, channels, nodes, the
/// sensor's figures, the surest tracks, OSPA.
std::string status_text(const Heard& heard, Heard::Clock::time_point now);

}  // namespace lookout::tools
