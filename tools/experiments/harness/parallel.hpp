#pragma once

#include <cstddef>
#include <functional>

namespace lookout::tools {

/// Calls task(0) ... task(count - 1), each once and in no order, from several threads at once.
/// @param jobs threads; 0: all cores.
/// @throws what the first failing task threw, when no thread works any more; tasks not begun by then are left
/// out.
void run_in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task);

}  // namespace lookout::tools
