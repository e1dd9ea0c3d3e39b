#include "lcmtypes/node_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

using std::chrono::milliseconds;

TEST(NodeLoop, StopsAfterItsDuration) {
  Bus bus("memq://");
  NodeLoop loop(bus, {.duration = 0.1}, [] {});
  const auto begin = NodeLoop::Clock::now();
  loop.run();
  EXPECT_GE(NodeLoop::Clock::now() - begin, milliseconds(100));
  EXPECT_TRUE(loop.over());
}

TEST(NodeLoop, StopsAfterSilence) {
  Bus bus("memq://");
  int seen = 0;
  bus.subscribe<vehicle_state_t>("VEHICLE_STATE", [&](const auto&) { ++seen; });
  bus.publish("VEHICLE_STATE", to_wire(tests::example_state()));
  NodeLoop(bus, {.idle_exit = 0.05}, [] {}).run();
  EXPECT_EQ(seen, 1);
}

TEST(NodeLoop, StopsWhenASignalCame) {
  Bus bus("memq://");
  bool stop = false;
  NodeLoop loop(bus, {.stopped = [&] { return stop; }}, [&] { stop = true; });
  loop.run();  // The first call of every_second comes at once.
  EXPECT_TRUE(stop);
}

TEST(NodeLoop, WaitsUntilDoneOrTheDeadline) {
  Bus bus("memq://");
  bool seen = false;
  bus.subscribe<vehicle_state_t>("VEHICLE_STATE", [&](const auto&) { seen = true; });
  bus.publish("VEHICLE_STATE", to_wire(tests::example_state()));
  NodeLoop loop(bus, {}, [] {});
  const auto begin = NodeLoop::Clock::now();
  EXPECT_TRUE(loop.wait_until(begin + std::chrono::minutes(10), [&] { return seen; }));
  EXPECT_TRUE(loop.wait_until(NodeLoop::Clock::now() + milliseconds(20)));
}

TEST(NodeLoop, SaysThatItWasStoppedWhileWaiting) {
  Bus bus("memq://");
  NodeLoop loop(bus, {.duration = 0.02}, [] {});
  EXPECT_FALSE(loop.wait_until(NodeLoop::Clock::time_point::max()));
}

TEST(NodeLoop, RefusesLimitsThatAreNotAboveZero) {
  Bus bus("memq://");
  EXPECT_THROW(NodeLoop(bus, {.duration = 0.0}, [] {}), std::invalid_argument);
  EXPECT_THROW(NodeLoop(bus, {.idle_exit = -1.0}, [] {}), std::invalid_argument);
}

// All that has arrived is taken in before there is work, and what work is left is done without waiting.
TEST(NodeLoop, WorksOffWhatItTookIn) {
  Bus bus("memq://");
  int taken = 0, most_taken_before_work = 0, left = 0;
  bus.subscribe<vehicle_state_t>("VEHICLE_STATE", [&](const auto&) { ++taken, ++left; });
  for (int i = 0; i < 5; ++i) bus.publish("VEHICLE_STATE", to_wire(tests::example_state()));
  NodeLoop loop(bus, {}, [] {});
  loop.work_by([&] {
    most_taken_before_work = std::max(most_taken_before_work, taken);
    if (left > 0) --left;
    return left > 0;
  });
  EXPECT_TRUE(loop.wait_until(NodeLoop::Clock::now() + std::chrono::minutes(1),
                              [&] { return taken == 5 && left == 0; }));
  EXPECT_EQ(most_taken_before_work, 5);
}

// The watchdog is fed by the loop itself, so that a handler that hangs leaves it hungry.
TEST(NodeLoop, IsNotAliveWhileAHandlerHangs) {
  Bus bus("memq://");
  int fed = 0;
  bool hung = false;
  bus.subscribe<vehicle_state_t>("VEHICLE_STATE", [&](const auto&) {
    const int before = fed;
    std::this_thread::sleep_for(milliseconds(1500));
    hung = fed == before;
  });
  bus.publish("VEHICLE_STATE", to_wire(tests::example_state()));
  NodeLoop loop(bus, {.alive = [&] { ++fed; }}, [] {});
  EXPECT_TRUE(
      loop.wait_until(NodeLoop::Clock::now() + std::chrono::minutes(1), [&] { return hung && fed >= 2; }));
}

TEST(NodeLoop, WhatIsOverheardDoesNotKeepItAwake) {
  Bus bus("memq://");
  bus.overhear("LOOKOUT_STATUS", [](auto) {});
  NodeLoop loop(bus, {.duration = 60.0, .idle_exit = 0.1},
                [&bus] { bus.publish("LOOKOUT_STATUS", to_wire(tests::example_state())); });
  const auto begin = NodeLoop::Clock::now();
  loop.run();
  EXPECT_LT(NodeLoop::Clock::now() - begin, std::chrono::seconds(30));
}

}  // namespace
}  // namespace lookout::lcmtypes
