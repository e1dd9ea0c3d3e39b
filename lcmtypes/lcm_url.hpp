#pragma once

#include <string>

namespace lookout::lcmtypes {

/// Refuses what LCM 1.3.1 would misread: it warns of a value or a key that it does not know and goes on with
/// its own, opens port 0 where none is given, and waits there for ever. Of mpudpm nothing is checked.
/// @param url empty or udpm://ADDRESS:PORT?ttl=N&recv_buf_size=N (or udpm:// with LCM's address),
/// tcpq://HOST:PORT, memq:// or file://PATH?speed=X.
/// @throws core::InputError naming the part and what is accepted.
void check_url(const std::string& url);

}  // namespace lookout::lcmtypes
