#pragma once

#include <cstddef>

namespace lookout::testing {

/// How many times this program has called operator new so far. Programs that ask link allocation_counter.cpp,
/// which replaces operator new.
std::size_t allocations();

}  // namespace lookout::testing
