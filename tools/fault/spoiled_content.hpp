#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "tools/fault/fault_message.hpp"

/// What faults do to a message's content. Pure functions; a message without content stays as it is.
namespace lookout::tools {

/// Times so much later [us].
void shift_time(FaultMessage& message, std::int64_t shift);
/// Numbers so much higher; vehicle states have none.
void shift_sequence(FaultMessage& message, std::int64_t shift);
/// The content of another message under the message's own time and number.
void freeze(FaultMessage& message, const FaultMessage::Content& content);
/// scale: ranges (a vehicle: its position) times `factor`; degrees: bearings (heading) in degrees; mirrored:
/// bearings (heading) with the other sign.
void falsify(FaultMessage& message, Wrongness wrongness, double factor);
/// A message of random bytes, 0 to 255 of them, in place of this one.
FaultMessage garbage_like(const FaultMessage& message, core::Random& random);

}  // namespace lookout::tools
