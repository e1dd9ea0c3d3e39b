#pragma once

#include <string>

#include "tools/cli/options.hpp"
#include "tools/command_line/command_flags.hpp"

namespace lookout::tools {

/// What a command makes of `words`. @throws std::invalid_argument with what the person would read.
Options parsed(void (*declare)(CLI::App& app, Options& options), const std::string& words);

/// The help of a command.
std::string help_of(void (*declare)(CLI::App& app, Options& options));

}  // namespace lookout::tools
