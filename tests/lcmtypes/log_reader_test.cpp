#include "lcmtypes/log_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <lcm/lcm-cpp.hpp>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr int kEvents = 10;
constexpr std::int64_t kEventSize = 28 + 7 + 100;  // LCM's event header, "CHANNEL" and 100 bytes.

/// A log of kEvents equal events, whose path is returned.
std::string write_log(const tests::TemporaryDirectory& directory) {
  const std::string path = directory.file("log.lcm");
  lcm::LogFile log(path, "w");
  std::string payload(100, 'x');
  for (int i = 0; i < kEvents; ++i) {
    lcm::LogEvent event{};
    event.timestamp = i;
    event.channel = "CHANNEL";
    event.datalen = static_cast<int>(payload.size());
    event.data = payload.data();
    log.writeEvent(&event);
  }
  return path;
}

int read_all(LogReader& log) {
  int count = 0;
  while (const auto message = log.next()) {
    EXPECT_EQ(message->channel, "CHANNEL");
    EXPECT_EQ(message->bytes.size(), 100u);
    ++count;
  }
  return count;
}

TEST(LogReader, ReadsAWholeLogWithoutDamage) {
  const tests::TemporaryDirectory directory;
  LogReader log(write_log(directory));
  EXPECT_EQ(read_all(log), kEvents);
  EXPECT_EQ(log.messages(), kEvents);
  EXPECT_EQ(log.damages(), 0);
  EXPECT_EQ(log.bytes_lost(), 0);
}

TEST(LogReader, SaysWhereTheBytesOfAMessageStand) {
  const tests::TemporaryDirectory directory;
  LogReader log(write_log(directory));
  log.next();
  // The second event's bytes stand behind one event and the second's header and channel name.
  EXPECT_EQ(log.next()->offset, kEventSize + 28 + 7);
}

TEST(LogReader, CountsACutEnd) {
  const tests::TemporaryDirectory directory;
  const std::string path = write_log(directory);
  std::filesystem::resize_file(path, 6 * kEventSize + 50);
  LogReader log(path);
  EXPECT_EQ(read_all(log), 6);
  EXPECT_EQ(log.damages(), 1);
  EXPECT_EQ(log.bytes_lost(), 50);
}

TEST(LogReader, StepsOverDamageInTheMiddle) {
  const tests::TemporaryDirectory directory;
  const std::string path = write_log(directory);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(4 * kEventSize);
    file.write("\0\0\0\0", 4);  // The fifth event's mark.
  }
  LogReader log(path);
  EXPECT_EQ(read_all(log), kEvents - 1);
  EXPECT_EQ(log.bytes_lost(), kEventSize);
}

/// A log whose fifth event states another length of its data, written over bytes 24 to 27 of its header.
void state_length(const std::string& path, std::uint32_t length) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(4 * kEventSize + 24);
  for (int shift = 24; shift >= 0; shift -= 8)
    file.put(static_cast<char>(length >> static_cast<unsigned>(shift)));
}

TEST(LogReader, LosesOneEventAloneByADamagedLength) {
  // Beyond the file, beyond memory, over two events that follow, and short of its own data.
  for (const std::uint32_t length : {0x7fffffffU, 0xffffffffU, 300U, 50U}) {
    const tests::TemporaryDirectory directory;
    const std::string path = write_log(directory);
    state_length(path, length);
    LogReader log(path);
    int whole = 0;
    while (const auto message = log.next()) whole += message->bytes.size() == 100 ? 1 : 0;
    EXPECT_EQ(whole, kEvents - 1) << length;
    EXPECT_EQ(log.damages(), 1) << length;
  }
}

TEST(LogReader, ReadsAnEmptyLogAndRefusesNoFile) {
  const tests::TemporaryDirectory directory;
  LogReader log(directory.write("empty.lcm", ""));
  EXPECT_FALSE(log.next());
  EXPECT_EQ(log.damages(), 0);
  EXPECT_THROW(LogReader("/nowhere/at/all.lcm"), core::InputError);
  EXPECT_THROW(LogReader(directory.path()), core::InputError);
}

TEST(LogReader, SurvivesAFileThatIsNoLog) {
  const tests::TemporaryDirectory directory;
  LogReader log(directory.write("no.lcm", std::string(1000, 'y')));
  EXPECT_FALSE(log.next());
  EXPECT_EQ(log.damages(), 1);
  EXPECT_EQ(log.bytes_lost(), 1000);
}

}  // namespace
}  // namespace lookout::lcmtypes
