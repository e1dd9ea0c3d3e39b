#pragma once

#include <cstdint>
#include <string>

#include "tools/doctor/findings.hpp"

/// What `lookout doctor` asks the system. Nothing is changed by it, and nothing is sent.
namespace lookout::tools {

Route route_to(const MulticastUrl& url);  ///< By the system's own choice.
/// What a socket gets that asks as LCM would [bytes]; 0 where there is no socket.
std::int64_t granted_buffer(const MulticastUrl& url);
std::int64_t most_allowed_buffer();  ///< net.core.rmem_max [bytes]; 0 where it is not told.
int current_year();                  ///< Of the wall clock.
bool is_clock_synchronized();        ///< As the kernel says.
/// Why nobody could write into a directory; empty: one can.
std::string write_error(const std::string& directory);
std::int64_t free_bytes(const std::string& directory);  ///< For who runs this; 0 where it is not there.
std::string types_jar();  ///< Where lookout_types.jar is; empty: nowhere that we know of.

}  // namespace lookout::tools
