#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"

namespace lookout::tracking {

/// Makes an initiator; never null. @throws std::invalid_argument on a value out of range.
using MakeInitiator = std::function<std::unique_ptr<Initiator>(const InitiatorConfig&)>;

/// Adds an initiator from outside the library to those that go by name: `initiator_names()`, a configuration
/// and the command line know it from then on, for points and as a birth method.
///
/// The table behind it is the one piece of global state here: it only grows, is not guarded, and is meant to
/// be filled at the start of a program, before there are threads.
/// @param name letters, digits and underscores.
/// @param keys what it uses of the `initiator:` part of a configuration, common keys and its own; another key
///   is refused there.
/// @throws std::invalid_argument on another name, a name that an initiator or a tracker has, or an empty
/// `make`.
void register_initiator(const std::string& name, MakeInitiator make, std::vector<InitiatorKey> keys = {});

/// Whether a method uses each plot's own error and the speeds themselves, so that it works on a sonar's scans
/// as they are; the others are made for targets that move by more than the errors between two scans, and need
/// a LocalInitiator there.
bool suits_any_sensor(const std::string& name);

/// What an initiator works on.
enum class InitiatorUse {
  points,  ///< Recorded points (`lookout initiate`), whose accuracy the configuration gives.
  births   ///< The scans of a tracker, whose accuracy is the sensor's; its proposals are verified.
};

/// Reads the `initiator:` part of a configuration for one initiator, and calls map.finish().
/// @param name empty or of no initiator: the keys of all are accepted.
/// @throws core::InputError on a key that it does not use, naming those that it does, or a value out of
/// range.
void read_initiator_config(const core::YamlMap& map, const std::string& name, InitiatorUse use,
                           InitiatorConfig& config);

/// The names that `make_initiator` accepts, in the order in which they are shown to a user.
std::vector<std::string> initiator_names();

/// An initiator by name.
/// @throws std::invalid_argument naming what is accepted: an unknown name, a variant that the method does not
/// have, or a value out of range.
std::unique_ptr<Initiator> make_initiator(const std::string& name, const InitiatorConfig& config);

}  // namespace lookout::tracking
