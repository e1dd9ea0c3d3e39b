#pragma once

#include <string>

#include "tools/experiments/harness/study.hpp"

/// What a study does when all its runs are in the log of its directory; `lookout merge` shares it with the
/// command that ran them.
namespace lookout::tools {

/// Results, report, extras and plots of an experiment; loads the plug-ins that it was run with.
/// @throws core::InputError as `run_monte_carlo`, and where a plug-in is not there.
void finish_experiment(const Study& study, const std::string& out);

}  // namespace lookout::tools
