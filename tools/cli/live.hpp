#pragma once

#include <memory>
#include <string>

#include "lcmtypes/node_loop.hpp"
#include "tools/cli/options.hpp"

/// What the live commands share.
namespace lookout::tools {

/// --duration, --idle-exit and the stop signals, which are caught from now on.
/// @throws core::InputError on a value that is not above 0.
lcmtypes::LoopLimits loop_limits(const Options& options);

/// The link, as soon as it can be opened: a unit may start before its network. Says once that it waits.
/// @return nothing where a stop signal or the end of --duration came first.
/// @throws core::InputError on a bad URL; lcmtypes::BusError where waiting would not help: a file.
std::unique_ptr<lcmtypes::Bus> open_when_possible(const std::string& url, const lcmtypes::LoopLimits& limits);

/// The exit status of a live command that has ended: 1, told, where its transport's server is gone, so that a
/// service is started again, or where the log that it wrote is not whole on the disk. After it the bus is
/// closed where it was such a log.
int end_of_link(lcmtypes::Bus& bus);

}  // namespace lookout::tools
