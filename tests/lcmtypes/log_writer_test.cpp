#include "lcmtypes/log_writer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <lookout/vehicle_state_t.hpp>

#include "core/input_error.hpp"
#include "lcmtypes/inbox.hpp"
#include "lcmtypes/log_reader.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::lcmtypes {
namespace {

vehicle_state_t state_at(std::int64_t utime) {
  vehicle_state_t state{};
  state.utime = utime;
  return state;
}

TEST(LogWriter, WritesWhatTheReaderReads) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("dive.lcmlog");
  LogWriter writer(path);
  writer.add("VEHICLE_STATE", 5, state_at(7));
  writer.add("AUV1_VEHICLE_STATE", 6, state_at(8));
  writer.close();

  LogReader reader(path);
  const auto first = reader.next(), second = reader.next();
  ASSERT_TRUE(first && second && !reader.next());
  EXPECT_EQ(first->channel, "VEHICLE_STATE");
  EXPECT_EQ(first->log_utime, 5);
  EXPECT_EQ(decode<vehicle_state_t>(first->bytes.data(), first->bytes.size())->utime, 7);
  EXPECT_EQ(second->channel, "AUV1_VEHICLE_STATE");
  EXPECT_EQ(reader.damages(), 0);
}

TEST(LogWriter, LeavesNothingBehindWhereItIsNotClosed) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("dive.lcmlog");
  {
    LogWriter writer(path);
    writer.add("VEHICLE_STATE", 5, state_at(7));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(LogWriter, RefusesWhatIsNoPlainFile) {
  const tests::TemporaryDirectory directory;
  EXPECT_THROW(LogWriter(directory.path()), core::InputError);
  EXPECT_THROW(LogWriter(directory.file("absent/dive.lcmlog")), core::InputError);
}

}  // namespace
}  // namespace lookout::lcmtypes
