#pragma once

#include <string>

namespace lookout::tools {

/// The commit that this was built from (`-dirty` where files differed), or the release where there is no git.
std::string version();

}  // namespace lookout::tools
