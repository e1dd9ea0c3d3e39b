#include "tools/experiments/harness/task_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lookout::tools {
namespace {

TEST(TaskPool, CallsEachTaskOnce) {
  for (const int jobs : {0, 1, 5}) {
    std::vector<std::atomic<int>> calls(100);
    for_each_task(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(TaskPool, AFailureComesOutAndEndsTheWork) {
  std::atomic<int> calls{0};
  const auto fail = [&](std::size_t) {
    ++calls;
    throw std::runtime_error("broken");
  };
  EXPECT_THROW(for_each_task(1000, 3, fail), std::runtime_error);
  EXPECT_LE(calls, 3);  // one a thread
}

}  // namespace
}  // namespace lookout::tools
