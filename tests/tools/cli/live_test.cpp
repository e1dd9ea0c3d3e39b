#include "tools/cli/live.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(LoopLimits, RefuseTimesThatAreNotAboveZero) {
  for (const double wrong : {0.0, -1.0}) {
    Options options;
    options.duration = wrong;
    EXPECT_THROW(loop_limits(options), core::InputError);
    options = {};
    options.idle_exit = wrong;
    EXPECT_THROW(loop_limits(options), core::InputError);
  }
}

/// Ends with 0 where SIGTERM is caught and asked for; in a process of its own, since signals are remembered.
void stop_by_a_signal() {
  const auto limits = loop_limits({});
  const bool before = limits.stopped();
  std::raise(SIGTERM);
  std::_Exit(!before && limits.stopped() ? 0 : 1);
}

TEST(LoopLimits, EndOnASignal) {
  EXPECT_EXIT(stop_by_a_signal(), testing::ExitedWithCode(0), "");
}

TEST(LoopLimits, CarryTheTimes) {
  Options options;
  options.duration = 3.0;
  EXPECT_EXIT(std::_Exit(loop_limits(options).duration == 3.0 && !loop_limits(options).idle_exit ? 0 : 1),
              testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lookout::tools
