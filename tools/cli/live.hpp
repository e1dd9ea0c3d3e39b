#pragma once

#include "lcmtypes/node_loop.hpp"
#include "tools/cli/options.hpp"

/// What the live commands share.
namespace lookout::tools {

/// --duration, --idle-exit and the stop signals, which are caught from now on.
/// @throws core::InputError on a value that is not above 0.
lcmtypes::LoopLimits loop_limits(const Options& options);

}  // namespace lookout::tools
