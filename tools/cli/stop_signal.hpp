#pragma once

namespace lookout::tools {

/// From now on SIGINT and SIGTERM do not end the process but are remembered, so that a node can flush and
/// stop.
void catch_stop_signals();

/// Whether one of them has come.
bool stop_requested();

}  // namespace lookout::tools
