#include "lcmtypes/status_board.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lookout::lcmtypes {
namespace {

TEST(StatusBoard, PutsTheNodeIdWhereWaitForReadsIt) {
  Bus bus("memq://");
  std::vector<std::int32_t> heard;
  bus.subscribe_bytes("LOOKOUT_STATUS",
                      [&](auto bytes) { heard.push_back(status_node_id(bytes).value_or(-1)); });
  StatusBoard(bus, "LOOKOUT_STATUS", "lookout track", 7).publish({1'000'000, 1, 2, 3}, "nothing wrong");
  StatusBoard(bus, "LOOKOUT_STATUS", "lookout sim", 0).publish({}, "");
  bus.drain();
  EXPECT_EQ(heard, (std::vector<std::int32_t>{7, 0}));
}

TEST(StatusBoard, ReadsBytesSixteenToNineteenAloneAndNothingFromLess) {
  std::array<std::uint8_t, 20> bytes{};
  bytes[18] = 1;
  bytes[19] = 2;
  EXPECT_EQ(status_node_id(bytes), 258);  // Big endian: 1 * 256 + 2.
  EXPECT_FALSE(status_node_id(std::span(bytes).first(19)));
}

}  // namespace
}  // namespace lookout::lcmtypes
