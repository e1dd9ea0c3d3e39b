#pragma once

#include <cstddef>
#include <functional>

namespace lookout::tools {

/// Calls `work` once for each of 0 .. count - 1 in order of start, on `jobs` threads (0: as many as the
/// machine has cores), under a progress bar. `work` is called from several threads at once.
/// @throws what the first failing call threw, when all that had begun have ended; no more are begun then.
void for_each_task(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace lookout::tools
