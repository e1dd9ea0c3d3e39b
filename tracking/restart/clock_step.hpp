#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/tracking_memory.hpp"

namespace lookout::tracking {

/// By how much the clock of all senders was set between the newest scan of `before` and `first` [us], where
/// the sensor's numbers go on and its period says how much time they took; above 0: ahead. Nothing where they
/// do not go on. A leap ahead may also be a sleep of all on board: it is a clock that was set where a vehicle
/// that was under way is where it was, and would be far from there had the time passed.
std::optional<std::int64_t> clock_step(const std::vector<core::RememberedScan>& before,
                                       const core::RememberedScan& first);

}  // namespace lookout::tracking
