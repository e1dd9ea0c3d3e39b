#include "lcmtypes/bus.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "core/input_error.hpp"
#include "tests/lcmtypes/example_messages.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::lcmtypes {
namespace {

using std::chrono::milliseconds;

TEST(Bus, TakesAMessageFromPublisherToHandler) {
  Bus bus("memq://");
  std::vector<std::int64_t> seen;
  bus.subscribe<sonar_scan_t>("SONAR_SCAN", [&](const core::SonarScan& scan) { seen.push_back(scan.utime); });
  bus.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  EXPECT_EQ(bus.handle_for(milliseconds(1000)), Bus::Heard::message);
  EXPECT_EQ(seen, std::vector<std::int64_t>{2'000'000});
}

TEST(Bus, WhatIsOverheardIsNoInput) {
  Bus bus("memq://");
  int overheard = 0, handled = 0;
  bus.overhear("A", [&](auto) { ++overheard; });
  bus.publish_bytes("A", std::vector<std::uint8_t>{1, 2});
  EXPECT_EQ(bus.handle_for(milliseconds(1000)), Bus::Heard::aside);
  bus.subscribe_bytes("A", [&](auto bytes) { handled += static_cast<int>(bytes.size()); });
  bus.publish_bytes("A", std::vector<std::uint8_t>{1, 2});
  EXPECT_EQ(bus.handle_for(milliseconds(1000)), Bus::Heard::message);
  EXPECT_EQ(overheard, 2);
  EXPECT_EQ(handled, 2);  // Once, of two bytes.
  EXPECT_LE(bus.arrival(), std::chrono::steady_clock::now());
}

TEST(Bus, WaitsNoLongerThanItIsTold) {
  Bus bus("memq://");
  EXPECT_EQ(bus.handle_for(milliseconds(1)), Bus::Heard::nothing);
  EXPECT_EQ(bus.drain(), Bus::Heard::nothing);
}

TEST(Bus, GoesOnAfterAHandlerThatThrows) {
  Bus bus("memq://");
  bus.subscribe<sonar_scan_t>("SONAR_SCAN", [](const auto&) { throw std::runtime_error("no"); });
  for (int i = 0; i < 3; ++i) bus.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  bus.drain();
  EXPECT_EQ(bus.inbox().counts("SONAR_SCAN").handler_errors, 3);
}

TEST(Bus, GoesOnAfterGarbageOnItsChannel) {
  Bus bus("memq://");
  int seen = 0;
  bus.subscribe<sonar_scan_t>("SONAR_SCAN", [&](const auto&) { ++seen; });
  bus.publish("SONAR_SCAN", to_wire(tests::example_state()));  // A message of another type.
  bus.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  bus.drain();
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(bus.inbox().counts("SONAR_SCAN").undecodable, 1);
}

TEST(Bus, RefusesAMessageAboveOneDatagram) {
  Bus bus("memq://");
  ground_truth_t truth{};
  truth.num_targets = 2000;
  truth.targets.resize(2000);
  EXPECT_THROW(bus.publish("GROUND_TRUTH", truth), std::length_error);
}

TEST(Bus, TakesAnImageOfManyDatagrams) {
  Bus bus("memq://");
  std::size_t pixels = 0;
  bus.subscribe<sonar_image_t>("SONAR_IMAGE",
                               [&](const core::SonarImage& image) { pixels = image.intensity.size(); });
  core::SonarImage image = tests::example_image();
  image.num_bins = 32'000;
  image.intensity.assign(64'000, 1.0);
  bus.publish("SONAR_IMAGE", to_wire(image));
  bus.drain();
  EXPECT_EQ(pixels, 64'000u);
}

TEST(Bus, WritesAFileThatReadsBackToItsEnd) {
  const tests::TemporaryDirectory directory;
  const std::string log = directory.file("scans.lcm");
  {
    Bus writer("file://" + log + "?mode=w");
    for (int i = 0; i < 5; ++i) writer.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  }
  Bus reader("file://" + log + "?speed=0");
  int seen = 0;
  reader.subscribe<sonar_scan_t>("SONAR_SCAN", [&](const auto&) { ++seen; });
  while (reader.handle_for(milliseconds(1000)) == Bus::Heard::message) {
  }
  EXPECT_EQ(seen, 5);
  EXPECT_EQ(reader.handle_for(milliseconds(1000)), Bus::Heard::closed);
}

/// No file grows beyond this while it lives: what a full disk looks like.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

// LCM writes through a buffer of the C library and looks at none of its errors.
TEST(Bus, SaysWhatOfALogIsNotOnTheDisk) {
  const tests::TemporaryDirectory directory;
  const std::string log = directory.file("cut.lcm");
  const FullDisk disk(600);
  Bus writer("file://" + log + "?mode=w");
  for (int i = 0; i < 5; ++i) writer.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  EXPECT_NE(writer.close_log().find(log + ": only 600 of "), std::string::npos);
}

TEST(Bus, ALogThatIsWholeAndALinkLackNothing) {
  const tests::TemporaryDirectory directory;
  const std::string log = directory.file("whole.lcm");
  Bus writer("file://" + log + "?mode=w");
  for (int i = 0; i < 5; ++i) writer.publish("SONAR_SCAN", to_wire(tests::example_scan()));
  EXPECT_EQ(writer.close_log(), "");
  EXPECT_EQ(Bus("file://" + log).close_log(), "");
  EXPECT_EQ(Bus("memq://").close_log(), "");
}

// The open would wait for the other end, and SIGTERM with it.
TEST(Bus, RefusesAPipe) {
  const tests::TemporaryDirectory directory;
  ASSERT_EQ(mkfifo(directory.file("pipe").c_str(), 0600), 0);
  EXPECT_THROW(Bus("file://" + directory.file("pipe")), core::InputError);
  EXPECT_THROW(Bus("file://" + directory.file("pipe") + "?mode=w"), core::InputError);
}

TEST(Bus, ADotInAChannelIsItself) {
  Bus bus("memq://");
  int seen = 0;
  bus.subscribe<sonar_scan_t>("auv1.x/SONAR_SCAN", [&](const auto&) { ++seen; });
  bus.publish("auv1.x/SONAR_SCAN", to_wire(tests::example_scan()));
  bus.publish("auv1_x/SONAR_SCAN", to_wire(tests::example_scan()));
  while (bus.handle_for(milliseconds(20)) == Bus::Heard::message) {
  }
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(bus.inbox().counts("auv1.x/SONAR_SCAN").received, 1);
}

TEST(Bus, OnlyMulticastIsMadeAnewOrWaitedFor) {
  EXPECT_FALSE(Bus("memq://").reopen());
  EXPECT_TRUE(Bus::may_come_up("udpm://239.255.76.67:7667?ttl=0"));
  EXPECT_FALSE(Bus::may_come_up("file:///nowhere"));
}

TEST(Bus, AServerThatIsNotThereIsLostAndAFileReadThroughIsNot) {
  Bus bus("tcpq://127.0.0.1:9");
  bus.subscribe<sonar_scan_t>("SONAR_SCAN", [](const auto&) {});
  EXPECT_EQ(bus.handle_for(milliseconds(100)), Bus::Heard::closed);
  EXPECT_TRUE(bus.lost_server());
}

TEST(Bus, SaysWhatIsWrongWithItsUrl) {
  EXPECT_THROW(Bus("http://localhost"), core::InputError);
  EXPECT_THROW(Bus("file:///nowhere/at/all.lcm"), BusError);
}

}  // namespace
}  // namespace lookout::lcmtypes
