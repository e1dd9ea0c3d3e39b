#pragma once

#include <string>

#include "tools/import/import_summary.hpp"

namespace lookout::tools {

/// Makes a recording of images of a folder of PGM pictures, beams by ranges, whose geometry and times a YAML
/// file gives; docs/import.md has its keys.
/// @param geometry path of that file; empty: geometry.yaml in the folder.
/// @param out recording directory, made where it is not.
/// @throws core::InputError naming file, line and key, or where no picture is whole: then nothing is written.
ImportSummary import_pgm(const std::string& folder, const std::string& geometry, const std::string& out);

}  // namespace lookout::tools
