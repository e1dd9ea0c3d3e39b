#include "tools/experiments/harness/task_pool.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "tools/cli/progress_bar.hpp"

namespace lookout::tools {
namespace {

/// What the threads share: the counters, the first error and the bar.
class TaskQueue {
 public:
  TaskQueue(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work), bar_(count) {}

  void drain() {
    for (std::size_t i = next_++; i < count_; i = next_++) run(i);
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run(std::size_t i) {
    try {
      work_(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      next_ = count_;
    }
    const std::lock_guard lock(mutex_);
    bar_.show(++done_);
  }

  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
  ProgressBar bar_;
};

}  // namespace

void for_each_task(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  const auto wanted = jobs > 0 ? static_cast<unsigned>(jobs) : cores;
  TaskQueue queue(count, work);
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 1; k < wanted; ++k) threads.emplace_back([&queue] { queue.drain(); });
    queue.drain();
  }
  queue.rethrow();
}

}  // namespace lookout::tools
