#include "lcmtypes/state_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"

namespace lookout::lcmtypes {
namespace {

core::TrackingMemory example() {
  core::TrackingMemory memory;
  memory.next_id = 42;
  memory.utime = 7'000'000;
  memory.tracks.resize(1);
  memory.tracks[0].id = 11;
  memory.tracks[0].status = core::TrackStatus::confirmed;
  memory.tracks[0].state << 1.0, 2.0, 3.0, 4.0;
  memory.tracks[0].covariance.setIdentity();
  memory.tracks[0].existence = 0.9;
  for (int k = 0; k < 3; ++k) {
    core::SonarScan scan;
    scan.utime = k * 1'000'000;
    scan.sequence = k;
    scan.bearing_step = 0.1;
    scan.max_range = 100.0;
    scan.num_beams = 3;
    scan.returns = {{0.1, 10.0 + k, 1.0}};
    memory.scans.push_back({{scan.utime, {1.0 * k, 2.0, 0.3}, {0.0, 0.0}}, scan});
  }
  return memory;
}

TEST(StateFile, ComesBackAsItWas) {
  const tests::TemporaryDirectory directory;
  save_state(directory.file("state"), example());
  const LoadedState loaded = load_state(directory.file("state"));
  ASSERT_TRUE(loaded.memory) << loaded.refusal;
  EXPECT_EQ(loaded.memory->next_id, 42);
  EXPECT_EQ(loaded.memory->utime, 7'000'000);
  EXPECT_EQ(loaded.memory->tracks.at(0).id, 11);
  EXPECT_EQ(loaded.memory->tracks.at(0).state[3], 4.0);
  EXPECT_EQ(loaded.memory->scans.at(2).scan.returns.at(0).range, 12.0);
  EXPECT_EQ(loaded.memory->scans.at(2).vehicle.T_earth_body.north, 2.0);
}

TEST(StateFile, NoFileIsACleanStartWithoutAWord) {
  const LoadedState loaded = load_state("/nowhere/state");
  EXPECT_FALSE(loaded.memory);
  EXPECT_TRUE(loaded.refusal.empty());
}

TEST(StateFile, RefusesADirectoryAnotherVersionAndACutFile) {
  const tests::TemporaryDirectory directory;
  EXPECT_EQ(load_state(directory.path()).refusal, "is no plain file");
  EXPECT_EQ(read_state("lookout state 2\n").refusal, "is no state of this version");
  EXPECT_EQ(read_state("").refusal, "is no state of this version");
  const std::string text = state_text(example());
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_FALSE(read_state(text.substr(0, size)).memory) << size;
  EXPECT_FALSE(read_state(text + "x").memory);
}

// Every byte in turn: whatever it is, the checksum or what stands before it tells.
TEST(StateFile, SurvivesEveryDamagedByte) {
  const std::string text = state_text(example());
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string damaged = text;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    EXPECT_FALSE(read_state(damaged).memory) << i;
  }
}

TEST(StateFile, KeepsNoScansWhereThereWereNone) {
  const LoadedState loaded = read_state(state_text({}));
  ASSERT_TRUE(loaded.memory);
  EXPECT_TRUE(loaded.memory->scans.empty());
  EXPECT_EQ(loaded.memory->next_id, 1);
}

}  // namespace
}  // namespace lookout::lcmtypes
