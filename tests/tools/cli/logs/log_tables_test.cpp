#include "tools/cli/logs/log_tables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <lcm/lcm-cpp.hpp>

#include "core/files/csv.hpp"
#include "core/files/recording.hpp"
#include "core/input_error.hpp"
#include "tests/lcmtypes/example_messages.hpp"
#include "tests/support/log_message.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(LogTables, AreTheRecordingAndTheTracksWithTheirCovariance) {
  const tests::TemporaryDirectory directory;
  {
    lcm::LogFile file(directory.file("log"), "w");
    const core::Track track = tests::example_track(7);
    tests::log_message(file, "VEHICLE_STATE", lcmtypes::to_wire(tests::example_state()));
    tests::log_message(file, "SONAR_SCAN", lcmtypes::to_wire(tests::example_scan()));
    tests::log_message(file, "TRACKS", lcmtypes::to_wire({2'000'000, 4, 0}, std::span(&track, 1)).message);
  }
  write_log_tables(directory.file("log"), "", directory.path());
  EXPECT_EQ(core::read_recording(directory.path()).scans.at(0).returns.size(), 2u);
  constexpr std::array<std::string_view, 2> kColumns{"covariance_ne_m2", "covariance_ee_m2"};
  const core::CsvTable table(directory.file("tracks.csv"), kColumns);
  EXPECT_EQ(table.number(0, "covariance_ne_m2"), 1.0);  // Element (0, 1) of the example's 0, 1, ..., 15.
  EXPECT_EQ(table.number(0, "covariance_ee_m2"), 5.0);  // Element (1, 1).
  EXPECT_THROW(write_log_tables(directory.file("log"), "AUV1_", directory.path()), core::InputError);
}

TEST(LogTables, TakeTheTracksOfTheFusionWhereThereAreNoOthers) {
  const tests::TemporaryDirectory directory;
  const core::Track of_fusion = tests::example_track(8), own = tests::example_track(7);
  constexpr std::array<std::string_view, 1> kColumns{"id"};
  for (const bool has_own : {false, true}) {
    {
      lcm::LogFile file(directory.file("log"), "w");
      const auto message = [](const core::Track& track) {
        return lcmtypes::to_wire({2'000'000, 4, 0}, std::span(&track, 1)).message;
      };
      tests::log_message(file, "GLOBAL_TRACKS", message(of_fusion));
      if (has_own) tests::log_message(file, "TRACKS", message(own));
    }
    write_log_tables(directory.file("log"), "", directory.path());
    const core::CsvTable table(directory.file("tracks.csv"), kColumns);
    EXPECT_EQ(table.integer(0, "id"), has_own ? own.id : of_fusion.id);
  }
}

TEST(LogTables, TellWhatIsNotInThem) {
  const tests::TemporaryDirectory directory;
  {
    lcm::LogFile file(directory.file("log"), "w");
    const auto state = lcmtypes::to_wire(tests::example_state());
    for (const char* channel : {"VEHICLE_STATE", "VEHICLE_STATE", "OSPA", "TRACKS"})
      tests::log_message(file, channel, state);
  }
  const std::vector<std::string> expected{
      "OSPA: 1 messages refused: not one whole message of its type",
      "TRACKS: 1 messages refused: not one whole message of its type",
      "VEHICLE_STATE: 1 states that are not later than all before them are left out"};
  EXPECT_EQ(write_log_tables(directory.file("log"), "", directory.path()), expected);
}

}  // namespace
}  // namespace lookout::tools
