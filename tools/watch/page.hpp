#pragma once

#include <span>
#include <string_view>

namespace lookout::tools {

/// One file of the browser view, out of tools/watch/page/, as it was at the build.
struct PageFile {
  std::string_view path;  ///< "/", "/watch.js", ...
  std::string_view type;  ///< Its media type.
  std::string_view text;
};

/// All of them.
std::span<const PageFile> page_files();

}  // namespace lookout::tools
