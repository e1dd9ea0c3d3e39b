#include "core/files/scans_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using testing::error_of;

ReadScans read_text(const std::string& text) {
  const tests::TemporaryDirectory folder;
  std::vector<std::string> notes;
  return read_scans(folder.write("scans.csv", text), GeometryByTime(geometry_of(SonarParams())), notes);
}

TEST(ScansFile, TellsScansOfOneTimeApartByTheirSensor) {
  const auto read = read_text(
      "time_s,bearing_rad,range_m,intensity,sensor_id\n0,.1,5,1,1\n0,.2,6,1,1\n0,.3,7,1,2\n1,,,,1\n1,.1,5,1,"
      "2\n");
  ASSERT_EQ(read.scans.size(), 4u);
  EXPECT_EQ(read.scans[0].returns.size(), 2u);
  EXPECT_EQ(read.scans[1].sensor_id, 2);
  EXPECT_EQ(read.scans[3].sequence, 1);  // Each sensor counts its own.
}

TEST(ScansFile, ReadsBackSensorsSequencesAndClocks) {
  const tests::TemporaryDirectory folder;
  std::vector<SonarScan> scans(3);
  for (auto& scan : scans) set_geometry(scan, geometry_of(SonarParams()));
  scans[0].utime = 5;
  scans[0].sequence = 1000;
  scans[0].returns = {{0.1, 5.0, 1.0}};
  scans[1].utime = 1;  // Back, on another clock.
  scans[1].sensor_id = 2;
  scans[2].utime = 2;
  write_scans(folder.file("scans.csv"), scans, {0, 1, 1});
  std::vector<std::string> notes;
  const auto read = read_scans(folder.file("scans.csv"), GeometryByTime(geometry_of(SonarParams())), notes);
  EXPECT_EQ(read.clocks, (std::vector<int>{0, 1, 1}));
  EXPECT_EQ(read.scans[0].sequence, 1000);
  EXPECT_EQ(read.scans[1].sensor_id, 2);
  EXPECT_EQ(read.scans[1].utime, 1);
}

TEST(ScansFile, HasFourColumnsWhereTheySayAll) {
  const tests::TemporaryDirectory folder;
  std::vector<SonarScan> scans(2);
  scans[1].utime = 500'000;
  scans[1].sequence = 1;
  write_scans(folder.file("scans.csv"), scans, {0, 0});
  std::ifstream file(folder.file("scans.csv"));
  std::string header;
  std::getline(file, header);
  EXPECT_EQ(header, "time_s,bearing_rad,range_m,intensity");
}

TEST(ScansFile, RefusesAClockThatFallsAndTimesThatGoBackOnOne) {
  const std::string header = "time_s,bearing_rad,range_m,clock\n1,0,5,1\n";
  EXPECT_NE(error_of([&] { read_text(header + "2,0,5,0\n"); }).find(":3: clock: expected"),
            std::string::npos);
  EXPECT_NE(error_of([&] { read_text(header + "0,0,5,1\n"); }).find(":3: time_s: goes back in time"),
            std::string::npos);
}

}  // namespace
}  // namespace lookout::core
