#include "tools/experiments/harness/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lookout::tools {
namespace {

TEST(Parallel, DoesEveryTaskOnce) {
  std::vector<std::atomic<int>> done(100);
  run_in_parallel(done.size(), 3, [&](std::size_t i) { ++done[i]; });
  for (const auto& count : done) EXPECT_EQ(count, 1);
}

TEST(Parallel, AFailureComesOutAndEndsTheWork) {
  std::atomic<int> begun{0};
  const auto fail = [&](std::size_t) {
    ++begun;
    throw std::runtime_error("broken");
  };
  EXPECT_THROW(run_in_parallel(1000, 2, fail), std::runtime_error);
  EXPECT_LT(begun, 1000);
}

}  // namespace
}  // namespace lookout::tools
