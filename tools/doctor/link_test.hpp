#pragma once

#include <string>

#include "lcmtypes/bus.hpp"
#include "tools/doctor/findings.hpp"

/// What `lookout doctor` tries on the link itself.
namespace lookout::tools {

/// Sends test messages on a channel of its own and listens for them, at most two seconds.
LinkResult test_link(lcmtypes::Bus& bus);

/// Listens to the vehicle's channels for a second and a half.
/// @throws core::InputError on a bad prefix.
TrafficResult listen_to_traffic(lcmtypes::Bus& bus, const std::string& channel_prefix);

}  // namespace lookout::tools
