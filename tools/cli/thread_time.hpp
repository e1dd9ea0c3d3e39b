#pragma once

#include <ctime>

namespace lookout::tools {

/// Processor time of the calling thread [ms]. Unlike wall time it does not count what other programs take of
/// a shared machine.
inline double thread_time_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace lookout::tools
