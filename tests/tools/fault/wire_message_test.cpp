#include "tools/fault/wire_message.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"
#include "tests/tools/fault/fault_examples.hpp"
#include "tools/fault/spoiled_content.hpp"

namespace lookout::tools {
namespace {

TEST(WireMessage, WhatNobodyChangesLeavesAsItCame) {
  const auto bytes = wire_bytes(example_scan(2, 7));
  const FaultMessage message = read_message(Stream::scan, bytes, 0);
  EXPECT_EQ(message.utime, 2'000'000);
  EXPECT_EQ(wire_bytes(message), bytes);
}

TEST(WireMessage, AChangeGoesOut) {
  FaultMessage message = read_message(Stream::scan, wire_bytes(example_scan(2, 7)), 0);
  shift_sequence(message, 100);
  const FaultMessage again = read_message(Stream::scan, wire_bytes(message), 0);
  EXPECT_EQ(std::get<core::SonarScan>(again.content).sequence, 107);
}

TEST(WireMessage, WhatCannotBeReadPassesAsBytesAtTheTimeOfTheTraffic) {
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  const FaultMessage message = read_message(Stream::vehicle, bytes, 42);
  EXPECT_EQ(message.utime, 42);
  EXPECT_EQ(message.content.index(), 0u);
  EXPECT_EQ(wire_bytes(message), bytes);
}

}  // namespace
}  // namespace lookout::tools
