// What no sender should send: every received type, cut, stretched, damaged.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "lcmtypes/inbox.hpp"
#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

template <class Wire>
class HostileInput : public ::testing::Test {
 protected:
  HostileInput() {
    inbox_.on<Wire>("CHANNEL", [this](const auto&) { ++handled_; });
  }
  void take(const std::vector<std::uint8_t>& bytes) { inbox_.take("CHANNEL", bytes.data(), bytes.size()); }
  std::vector<std::uint8_t> good() const {
    return tests::encoded(tests::example_wire(static_cast<const Wire*>(nullptr)));
  }

  Inbox inbox_;
  int handled_ = 0;
};

using ReceivedTypes =
    ::testing::Types<vehicle_state_t, sonar_scan_t, sonar_image_t, ground_truth_t, motion_elements_t,
                     track_list_t, sensor_estimate_t, clutter_map_t, local_estimate_t>;
TYPED_TEST_SUITE(HostileInput, ReceivedTypes);

TYPED_TEST(HostileInput, AGoodMessagePasses) {
  this->take(this->good());
  EXPECT_EQ(this->handled_, 1);
  EXPECT_EQ(this->inbox_.bad_messages(), 0);
}

TYPED_TEST(HostileInput, CutAtEveryLengthIsRejectedAndCounted) {
  const auto good = this->good();
  for (std::size_t length = 0; length < good.size(); ++length)
    this->take({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)});
  EXPECT_EQ(this->handled_, 0);
  EXPECT_EQ(this->inbox_.counts("CHANNEL").undecodable, static_cast<std::int64_t>(good.size()));
}

TYPED_TEST(HostileInput, TrailingBytesAreRejected) {
  auto bytes = this->good();
  bytes.push_back(0);
  this->take(bytes);
  bytes.resize(100'000, 0xff);
  this->take(bytes);
  EXPECT_EQ(this->handled_, 0);
  EXPECT_EQ(this->inbox_.counts("CHANNEL").undecodable, 2);
}

TYPED_TEST(HostileInput, GarbageBehindTheRightFingerprintIsSurvived) {
  core::Random random(1000);
  const auto good = this->good();
  constexpr int kMessages = 3000;
  for (int i = 0; i < kMessages; ++i) {
    auto bytes = good;
    bytes.resize(8 + static_cast<std::size_t>(random.index(static_cast<int>(2 * good.size()))));
    for (std::size_t k = 8; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(random() & 0xffU);
    this->take(bytes);
  }
  const auto counts = this->inbox_.counts("CHANNEL");
  EXPECT_EQ(counts.received, kMessages);
  EXPECT_EQ(counts.handler_errors, 0);
  EXPECT_EQ(counts.undecodable + counts.refused + this->handled_, kMessages);
}

TYPED_TEST(HostileInput, SingleDamagedBytesAreSurvived) {
  const auto good = this->good();
  std::int64_t sent = 0;
  for (std::size_t k = 0; k < good.size(); ++k) {
    for (const int damage : {0x01, 0x80, 0xff}) {
      auto bytes = good;
      bytes[k] = static_cast<std::uint8_t>(bytes[k] ^ damage);
      this->take(bytes);
      ++sent;
    }
  }
  const auto counts = this->inbox_.counts("CHANNEL");
  EXPECT_EQ(counts.undecodable + counts.refused + this->handled_, sent);
  EXPECT_EQ(counts.handler_errors, 0);
  EXPECT_GT(counts.undecodable, 0);  // The fingerprint's eight bytes at least.
}

/// A scan on the wire with its 16-bit count of returns, which stands at byte 94, set to `count`.
std::vector<std::uint8_t> scan_claiming(std::int16_t count) {
  auto bytes = tests::encoded(to_wire(tests::example_scan()));
  constexpr std::size_t kCountAt = 8 + 8 + 8 + 4 + 6 * 8 + 2;
  bytes[kCountAt] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(count) >> 8U);
  bytes[kCountAt + 1] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(count) & 0xffU);
  return bytes;
}

TEST(HostileScan, AbsurdCountsAreRejected) {
  for (const int count : {-32768, -1, 0, 1, 3, 32767}) {
    const auto bytes = scan_claiming(static_cast<std::int16_t>(count));
    EXPECT_FALSE(decode<sonar_scan_t>(bytes.data(), bytes.size())) << count;
  }
  const auto bytes = scan_claiming(2);
  EXPECT_TRUE(decode<sonar_scan_t>(bytes.data(), bytes.size()));
}

TEST(HostileScan, NinetyReturnsAllNanAreAScanOfSilences) {
  auto wire = to_wire(tests::example_scan());
  wire.num_returns = 90;
  wire.bearing.assign(90, std::numeric_limits<double>::quiet_NaN());
  wire.range = wire.intensity = wire.bearing;
  const auto bytes = tests::encoded(wire);
  Inbox inbox;
  std::size_t returns = 0;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [&](const core::SonarScan& scan) { returns = scan.returns.size(); });
  inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
  EXPECT_EQ(returns, 90u);  // For the intake to count.
  EXPECT_EQ(inbox.counts("SONAR_SCAN").refused, 0);
}

TEST(HostileScan, AHeaderThatIsNotFiniteIsRefusedByReason) {
  auto wire = to_wire(tests::example_scan());
  wire.max_range = std::numeric_limits<double>::infinity();
  const auto bytes = tests::encoded(wire);
  Inbox inbox;
  inbox.on<sonar_scan_t>("SONAR_SCAN", [](const auto&) { FAIL() << "handed on"; });
  for (int i = 0; i < 3; ++i) inbox.take("SONAR_SCAN", bytes.data(), bytes.size());
  inbox.take("SONAR_SCAN", bytes.data(), 10);
  const auto refusals = inbox.refusals();
  ASSERT_EQ(refusals.size(), 2u);
  EXPECT_EQ(refusals[1].reason, "scan: header not finite");
  EXPECT_EQ(refusals[1].count, 3);
  EXPECT_EQ(refusals[0].count, 1);
}

}  // namespace
}  // namespace lookout::lcmtypes
