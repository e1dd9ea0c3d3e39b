#include "tools/experiments/harness/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lookout::tools {

void run_in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  const auto threads_wanted = jobs > 0 ? static_cast<unsigned>(jobs) : cores;
  std::vector<std::jthread> threads;
  for (unsigned k = 1; k < threads_wanted; ++k) threads.emplace_back(work);
  work();
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace lookout::tools
