#include "tools/import/oculus_packets.hpp"

#include <gtest/gtest.h>

#include "tests/tools/import/oculus_bytes.hpp"

namespace lookout::tools {
namespace {

using tests::oculus_packet;
using tests::OculusSpec;

std::span<const std::uint8_t> view(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/// All pings of some bytes, and what was said of the rest.
struct ReadAll {
  explicit ReadAll(const std::string& bytes) : packets(view(bytes), "dive.raw") {
    while (auto ping = packets.next()) pings.push_back(*ping);
  }
  OculusPackets packets;
  std::vector<OculusPing> pings;
};

void expect_values(const core::SonarImage& image) {
  ASSERT_EQ(image.num_beams(), 4);
  ASSERT_EQ(image.num_bins, 3);
  for (int beam = 0; beam < 4; ++beam)
    for (int bin = 0; bin < 3; ++bin) EXPECT_EQ(image.at(beam, bin), tests::oculus_value(beam, bin));
}

TEST(OculusPackets, TakesAPingWithItsUnevenBeams) {
  const ReadAll read(oculus_packet({}));
  ASSERT_EQ(read.pings.size(), 1u);
  const OculusPing& ping = read.pings.front();
  EXPECT_EQ(ping.number, 1000u);
  EXPECT_NEAR(ping.start, 0.5, 1e-9);
  EXPECT_EQ(ping.sound_speed, 1500.0);
  EXPECT_NEAR(ping.image.bearings[0], core::radians(-15.0), 1e-12);
  EXPECT_NEAR(ping.image.bearings[3], core::radians(20.0), 1e-12);
  EXPECT_EQ(ping.image.range_step, 0.25);
  EXPECT_EQ(ping.image.first_range, 0.125);  // Bin 0 reaches from the sonar to one step.
  expect_values(ping.image);
  EXPECT_TRUE(read.packets.damages().empty());
}

TEST(OculusPackets, TakesEverySizeOfValueAndBothVersions) {
  for (const int version : {1, 2})
    for (const int size : {1, 2, 4})
      for (const bool gains : {false, true}) {
        OculusSpec spec;
        spec.version = version;
        spec.value_size = size;
        spec.row_gains = gains;
        const ReadAll read(oculus_packet(spec));
        ASSERT_EQ(read.pings.size(), 1u) << version << " " << size;
        expect_values(read.pings[0].image);
        EXPECT_EQ(read.pings[0].has_row_gains, gains);
        EXPECT_EQ(read.pings[0].wrap > 0.0, version == 1);
      }
}

TEST(OculusPackets, AFanFromStarboardComesOutFromPort) {
  OculusSpec spec;
  spec.bearings = {2000, 0, -200, -1500};
  const ReadAll read(oculus_packet(spec));
  EXPECT_NEAR(read.pings[0].image.bearings[0], core::radians(-15.0), 1e-12);
  EXPECT_EQ(read.pings[0].image.at(0, 0), tests::oculus_value(3, 0));
}

std::string three_pings() {
  std::string bytes;
  for (std::uint32_t k = 0; k < 3; ++k) {
    OculusSpec spec;
    spec.number += k;
    bytes += oculus_packet(spec);
  }
  return bytes;
}

TEST(OculusPackets, BesideOtherPacketsAndBytesItFindsThePings) {
  std::string other(16 + 40, '\0');
  tests::put<std::uint16_t>(other, 0, 0x4F53);
  tests::put<std::uint16_t>(other, 6, 0x55);
  tests::put<std::uint32_t>(other, 10, 40);
  const ReadAll read("noise" + three_pings() + other + three_pings());
  EXPECT_EQ(read.pings.size(), 6u);
  EXPECT_EQ(read.packets.other_packets(), 1u);
  ASSERT_EQ(read.packets.damages().size(), 1u);
  EXPECT_EQ(read.packets.damages()[0], "dive.raw: byte 0: 5 bytes that are no packet");
}

/// What remains of three pings where one number of the second was damaged.
ReadAll with_damage(std::size_t at, std::uint32_t value) {
  std::string bytes = three_pings();
  tests::put(bytes, bytes.size() / 3 + at, value);
  return ReadAll(bytes);
}

TEST(OculusPackets, KeepsWhatIsWholeAndNamesTheRest) {
  const std::size_t size = oculus_packet({}).size();
  for (const std::size_t at :
       {std::size_t{0}, std::size_t{10}, std::size_t{106}, std::size_t{110}, std::size_t{118}}) {
    const ReadAll read = with_damage(at, 0x01020304);
    ASSERT_EQ(read.pings.size(), 2u) << at;
    EXPECT_EQ(read.pings[1].number, 1002u);
    ASSERT_EQ(read.packets.damages().size(), 1u) << at;
    EXPECT_EQ(read.packets.damages()[0].find("dive.raw: byte " + std::to_string(size) + ": "), 0u);
  }
  EXPECT_EQ(with_damage(118, 1).packets.damages()[0],
            "dive.raw: byte " + std::to_string(size) + ": ping 1001 states two sizes");
}

TEST(OculusPackets, ACutEndIsNamedAndEveryCutIsSurvived) {
  const std::string whole = three_pings();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const ReadAll read(whole.substr(0, length));
    EXPECT_EQ(read.pings.size(), length / (whole.size() / 3));
    EXPECT_EQ(read.packets.damages().empty(), length % (whole.size() / 3) == 0);
  }
}

TEST(OculusPackets, AnyDamagedByteIsSurvived) {
  const std::string whole = three_pings();
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int damage : {0x01, 0x80, 0xff}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ damage);
      EXPECT_GE(ReadAll(bytes).pings.size(), 2u) << at;
    }
}

}  // namespace
}  // namespace lookout::tools
