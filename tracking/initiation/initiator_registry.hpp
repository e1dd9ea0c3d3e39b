#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"

namespace lookout::tracking {

/// The names that `make_initiator` accepts, in the order in which they are shown to a user.
std::vector<std::string> initiator_names();

/// An initiator by name.
/// @throws std::invalid_argument naming what is accepted: an unknown name, a variant that the method does not
/// have, or a value out of range.
std::unique_ptr<Initiator> make_initiator(const std::string& name, const InitiatorConfig& config);

}  // namespace lookout::tracking
