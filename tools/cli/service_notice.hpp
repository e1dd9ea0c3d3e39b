#pragma once

#include <string>

namespace lookout::tools {

/// Tells the service manager that started this process (systemd, Type=notify) how it is: "READY=1",
/// "WATCHDOG=1". Does nothing where none asks to be told, and never fails: the work goes on without it.
/// sd_notify(3), its datagram alone.
void notify_service_manager(const std::string& state);

}  // namespace lookout::tools
