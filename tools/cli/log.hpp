#pragma once

#include <string_view>

/// Messages for people, on stderr (spdlog stays behind this header: it is slow to compile).
namespace lookout::tools {

void log_info(std::string_view message);
void log_warning(std::string_view message);

}  // namespace lookout::tools
