#include "lcmtypes/node_loop.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

}  // namespace
}  // namespace lookout::lcmtypes
