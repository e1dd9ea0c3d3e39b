#pragma once

#include <string>
#include <vector>

namespace lookout::tools {

/// What an import did.
struct ImportSummary {
  std::string imported;               ///< One line: what is in the recording.
  std::vector<std::string> left_out;  ///< What is not, a line each.
  std::vector<std::string> notes;     ///< What else should be known, a line each.
};

}  // namespace lookout::tools
