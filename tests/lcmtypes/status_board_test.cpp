#include "lcmtypes/status_board.hpp"

#include <gtest/gtest.h>

#include <lookout/node_status_t.hpp>

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

TEST(StatusBoard, CarriesEveryFigure) {
  Bus bus("memq://");
  std::optional<node_status_t> status;
  bus.subscribe_bytes("LOOKOUT_STATUS",
                      [&](auto bytes) { status = decode<node_status_t>(bytes.data(), bytes.size()); });
  StatusBoard board(bus, "LOOKOUT_STATUS", "lookout track", 7);
  for (const double latency : {1.0, 5.0, 3.0}) board.add_latency(latency);
  board.publish({.utime = 1, .accepted = 2, .rejected = 3, .dropped = 4, .shed = 5}, "");
  bus.drain();
  ASSERT_TRUE(status);
  EXPECT_EQ(status->shed, 5);
  EXPECT_EQ(status->send_errors, 0);
  EXPECT_EQ(status->latency_ms_p50, 3.0);
  EXPECT_EQ(status->latency_ms_max, 5.0);
}

// Ten scans a second count past 32 bits after 13.6 years, the datagrams of a flood within a day.
TEST(StatusBoard, CarriesCountsBeyond32Bits) {
  constexpr std::int64_t kMany = std::int64_t{1} << 40;
  Bus bus("memq://");
  std::optional<node_status_t> status;
  bus.subscribe_bytes("LOOKOUT_STATUS",
                      [&](auto bytes) { status = decode<node_status_t>(bytes.data(), bytes.size()); });
  StatusBoard(bus, "LOOKOUT_STATUS", "lookout track", 7)
      .publish({.accepted = kMany, .rejected = kMany + 1, .dropped = kMany + 2, .shed = kMany + 3}, "");
  bus.drain();
  ASSERT_TRUE(status);
  EXPECT_EQ(status->accepted, kMany);
  EXPECT_EQ(status->rejected, kMany + 1);
  EXPECT_EQ(status->dropped, kMany + 2);
  EXPECT_EQ(status->shed, kMany + 3);
}

TEST(StatusBoard, ReadsBytesSixteenToNineteenAloneAndNothingFromLess) {
  std::array<std::uint8_t, 20> bytes{};
  bytes[18] = 1;
  bytes[19] = 2;
  EXPECT_EQ(status_node_id(bytes), 258);  // Big endian: 1 * 256 + 2.
  EXPECT_FALSE(status_node_id(std::span(bytes).first(19)));
}

TEST(StatusBoard, KnowsItsOwnWordsFromThoseOfAnother) {
  Bus bus("memq://");
  StatusBoard own(bus, "LOOKOUT_STATUS", "lookout track", 7), other(bus, "OTHER", "lookout track", 7);
  std::vector<bool> are_own;
  bus.subscribe_bytes("LOOKOUT_STATUS", [&](auto bytes) { are_own.push_back(own.take_own(bytes)); });
  bus.subscribe_bytes("OTHER", [&](auto bytes) { are_own.push_back(own.take_own(bytes)); });
  own.publish({.utime = 1}, "");
  own.publish({.utime = 2}, "");
  other.publish({.utime = 3}, "");
  other.publish({.utime = 2}, "");  // Word by word what we said, which has come back before.
  bus.drain();
  EXPECT_EQ(are_own, (std::vector<bool>{true, true, false, false}));
}

}  // namespace
}  // namespace lookout::lcmtypes
