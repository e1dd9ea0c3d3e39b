#pragma once

#include <string>

namespace lookout::tools {

/// The release that this belongs to, as in "0.1.0".
std::string release();

/// The commit that this was built from (`-dirty` where files differed), or the release where there is no git.
std::string version();

}  // namespace lookout::tools
