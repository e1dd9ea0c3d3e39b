#pragma once

#include <string>

#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// How much of the reasons is shown.
enum class Reasons {
  cut,   ///< The first ones, each cut to the screen's width.
  whole  ///< All, in full: what is printed once scrolls.
};

/// One screen of text, at most 80 columns and 24 lines but for whole reasons: health with its reasons,
/// channels, nodes, the sensor's figures, the surest tracks, OSPA.
std::string status_text(const Heard& heard, Heard::Clock::time_point now, Reasons shown = Reasons::cut);

}  // namespace lookout::tools
