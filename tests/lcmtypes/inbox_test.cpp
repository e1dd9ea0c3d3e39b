#include "lcmtypes/inbox.hpp"

#include <gtest/gtest.h>

#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

std::vector<std::uint8_t> scan_bytes(std::int64_t sequence) {
  auto scan = tests::example_scan();
  scan.sequence = sequence;
  return tests::encoded(to_wire(scan));
}

TEST(Inbox, HandsGoodMessagesToTheHandlerOfTheirChannel) {
  Inbox inbox;
  std::vector<std::int64_t> seen;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [&](const core::SonarScan& scan) { seen.push_back(scan.sequence); });
  const auto bytes = scan_bytes(3);
  inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
  inbox.take("ELSEWHERE", bytes.data(), bytes.size());
  EXPECT_EQ(seen, std::vector<std::int64_t>{3});
}

TEST(Inbox, CountsGapsAndRestarts) {
  Inbox inbox;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) {});
  for (const std::int64_t sequence : {1, 2, 5, 6, 1}) {
    const auto bytes = scan_bytes(sequence);
    inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
  }
  EXPECT_EQ(inbox.counts("SONAR_SCAN").lost, 2);  // 3 and 4.
  EXPECT_EQ(inbox.counts("SONAR_SCAN").restarts, 1);
}

TEST(Inbox, CountsGapsOfEachSensorAlone) {
  Inbox inbox;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) {});
  for (std::int64_t sequence = 0; sequence < 5; ++sequence) {
    for (const int sensor : {1, 2}) {
      auto scan = tests::example_scan();
      scan.sensor_id = sensor;
      scan.sequence = sequence + 1000 * sensor;
      const auto bytes = tests::encoded(to_wire(scan));
      inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
    }
  }
  EXPECT_EQ(inbox.counts("SONAR_SCAN").lost, 0);
  EXPECT_EQ(inbox.counts("SONAR_SCAN").restarts, 0);
}

TEST(Inbox, LetsNoExceptionOutOfAHandler) {
  Inbox inbox;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) { throw std::runtime_error("disk full"); });
  const auto bytes = scan_bytes(3);
  inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
  EXPECT_EQ(inbox.counts("SONAR_SCAN").handler_errors, 1);
  EXPECT_EQ(inbox.last_error(), "SONAR_SCAN: disk full");
  EXPECT_EQ(inbox.bad_messages(), 1);  // It was not used: it counts as refused.
  ASSERT_EQ(inbox.refusals().size(), 1u);
  EXPECT_EQ(text_of(inbox.refusals()[0]), "SONAR_SCAN: 1 messages refused: its handler failed");
}

TEST(Inbox, CountsWhatAReaderMakesNothingOf) {
  Inbox inbox;
  std::vector<int> seen;
  const auto read = [](std::span<const std::uint8_t> bytes) {
    return bytes.size() == 1 ? std::optional(int{bytes[0]}) : std::nullopt;
  };
  inbox.on_read("REPORT", read, [&](int value) { seen.push_back(value); });
  inbox.take("REPORT", "\5", 1);
  inbox.take("REPORT", "22", 2);
  EXPECT_EQ(seen, std::vector<int>{5});
  EXPECT_EQ(inbox.counts("REPORT").received, 2);
  EXPECT_EQ(inbox.counts("REPORT").undecodable, 1);
  EXPECT_EQ(inbox.last_error(), "REPORT: not one whole message of its type");
}

TEST(Inbox, HandsBytesOnUndecoded) {
  Inbox inbox;
  std::size_t size = 0;
  inbox.on_bytes("LOOKOUT_STATUS", [&](std::span<const std::uint8_t> bytes) { size = bytes.size(); });
  inbox.take("LOOKOUT_STATUS", "12345", 5);
  EXPECT_EQ(size, 5u);
}

TEST(Inbox, RefusesASecondHandlerOfOneChannel) {
  Inbox inbox;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) {});
  EXPECT_THROW(inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) {}), std::invalid_argument);
}

TEST(Inbox, LetsAnotherListenInBeforeOrAfterTheHandler) {
  Inbox inbox;
  int overheard = 0, handled = 0;
  inbox.overhear("A", [&](auto) { ++overheard; });
  inbox.on_bytes("A", [&](auto) { ++handled; });
  inbox.on_bytes("B", [&](auto) { ++handled; });
  inbox.overhear("B", [&](auto) { ++overheard; });
  inbox.overhear("C", [&](auto) { ++overheard; });
  for (const char* channel : {"A", "B", "C"}) inbox.take(channel, "1", 1);
  EXPECT_EQ(overheard, 3);
  EXPECT_EQ(handled, 2);
}

}  // namespace
}  // namespace lookout::lcmtypes
