#pragma once

#include <string>
#include <vector>

#include "tools/import/import_summary.hpp"

namespace lookout::tools {

/// Makes a recording of images of the packet streams of one Oculus sonar, in their order; docs/import.md says
/// what of them is used. The sonar stands at the origin, and its time begins at 0 with the first ping.
/// @param out recording directory, made where it is not.
/// @throws core::InputError where a file cannot be read, or none holds a whole ping: then nothing is written.
ImportSummary import_oculus(const std::vector<std::string>& files, const std::string& out);

}  // namespace lookout::tools
