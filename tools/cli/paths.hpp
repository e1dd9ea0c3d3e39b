#pragma once

#include <string>
#include <vector>

namespace lookout::tools {

/// Where the tools' data, scenarios and plot scripts are: $LOOKOUT_TOOLS, else ../share/lookout/tools beside
/// the installed program, else the source tree that this was built from.
std::string tools_directory();

/// Creates a directory and those above it. @throws core::InputError where that is not possible.
void make_directory(const std::string& path);

/// Runs a Python script of the tools directory on its arguments. A failure is a warning, never more: the data
/// are written already.
/// @return 0: it went well; 2: it refused its input and has said why; 1: anything else.
int run_plot_script(const std::string& script, const std::vector<std::string>& arguments);

}  // namespace lookout::tools
