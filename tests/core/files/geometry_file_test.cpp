#include "core/files/geometry_file.hpp"

#include <gtest/gtest.h>

#include "core/files/recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using testing::error_of;

SonarScan scan_at(std::int64_t utime, double max_range, std::int32_t sensor_id = 0) {
  SonarScan scan;
  scan.utime = utime;
  scan.sensor_id = sensor_id;
  set_geometry(scan, geometry_of(SonarParams()));
  scan.max_range = max_range;
  return scan;
}

TEST(GeometryFile, HoldsARowWhereSomethingChanges) {
  const tests::TemporaryDirectory folder;
  const std::vector<SonarScan> scans{scan_at(0, 150), scan_at(1, 150), scan_at(2, 75), scan_at(3, 75)};
  ASSERT_TRUE(write_geometry(folder.file("geometry.csv"), scans, {0, 0, 0, 0}, geometry_of(SonarParams())));
  const auto read = GeometryByTime::read(folder.file("geometry.csv"), geometry_of(SonarParams()));
  for (const auto& scan : scans) EXPECT_TRUE(same_geometry(scan, read.at(0, 0, scan.utime))) << scan.utime;
}

TEST(GeometryFile, IsNotWrittenWhereNothingChanges) {
  const tests::TemporaryDirectory folder;
  EXPECT_FALSE(write_geometry(folder.file("geometry.csv"), {scan_at(0, 150), scan_at(1, 150)}, {0, 0},
                              geometry_of(SonarParams())));
  EXPECT_FALSE(std::ifstream(folder.file("geometry.csv")).good());
}

TEST(GeometryFile, KeepsSensorsApart) {
  const tests::TemporaryDirectory folder;
  const std::vector<SonarScan> scans{scan_at(0, 100, 1), scan_at(0, 50, 2), scan_at(1, 100, 1),
                                     scan_at(1, 60, 2)};
  write_geometry(folder.file("geometry.csv"), scans, {0, 0, 0, 0}, geometry_of(SonarParams()));
  const auto read = GeometryByTime::read(folder.file("geometry.csv"), geometry_of(SonarParams()));
  for (const auto& scan : scans) EXPECT_EQ(read.at(0, scan.sensor_id, scan.utime).max_range, scan.max_range);
  EXPECT_EQ(read.at(0, 3, 0).max_range, 150.0);  // Of a sensor without a row: sonar.yaml's.
}

TEST(GeometryFile, TakesWhatIsMissingFromBefore) {
  const tests::TemporaryDirectory folder;
  const auto read =
      GeometryByTime::read(folder.write("geometry.csv", "time_s,max_range_m,num_beams\n1,50,\n2,,45\n"),
                           geometry_of(SonarParams()));
  EXPECT_EQ(read.at(0, 0, 0).max_range, 150.0);
  EXPECT_EQ(read.at(0, 0, 1'500'000).max_range, 50.0);
  EXPECT_EQ(read.at(0, 0, 2'000'000).max_range, 50.0);
  EXPECT_EQ(read.at(0, 0, 2'000'000).num_beams, 45);
}

TEST(GeometryFile, NamesLineAndColumnOfWhatCannotBe) {
  const tests::TemporaryDirectory folder;
  const auto error = [&](const std::string& row) {
    const std::string path =
        folder.write("g.csv", "time_s,num_beams,bearing_step_rad,max_range_m\n0,90,0.01,9\n" + row);
    return error_of([&] { GeometryByTime::read(path, geometry_of(SonarParams())); }).substr(path.size());
  };
  EXPECT_EQ(error("1,0,0.01,9\n").find(":3: num_beams: expected"), 0u);
  EXPECT_EQ(error("1,90,0,9\n").find(":3: bearing_step_rad: expected"), 0u);
  EXPECT_EQ(error("1,90,0.1,9\n").find(":3: bearing_step_rad: expected"), 0u);  // 9 rad in all.
  EXPECT_EQ(error("1,90,0.01,1e9\n").find(":3: max_range_m: got 1e+09"), 0u);
  EXPECT_EQ(error("-1,90,0.01,9\n").find(":3: time_s: goes back"), 0u);
}

}  // namespace
}  // namespace lookout::core
