#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// Four scans of a target at 250 m/s along x and of a plot elsewhere in the second: rows 1, 2, 4 and 5 are
/// the target's.
std::string write_points(const std::string& directory, const std::string& targets = "1,1,0,1,1") {
  const std::array<std::string, 5> points{"0,0,0,0", "1,2,500,0", "1,2,100,900", "2,4,1000,0", "3,6,1500,0"};
  const std::string path = directory + "/points.csv";
  std::ofstream file(path);
  file << "scan,time_s,x_m,y_m,target\n";
  for (std::size_t i = 0; i < points.size(); ++i) file << points[i] << "," << targets[2 * i] << "\n";
  return path;
}

Options options_of(const std::string& directory, const std::string& points) {
  Options options;
  options.method = "vct";
  options.inputs = {points};
  options.out = directory + "/tracks.csv";
  return options;
}

TEST(InitiateCommand, NamesTheTracksPointsAndItsCovariance) {
  const tests::TemporaryDirectory directory;
  ASSERT_EQ(initiate_command(options_of(directory.path(), write_points(directory.path()))), 0);
  constexpr std::array<std::string_view, 5> kColumns{"points", "x_m", "cov_x_x", "cov_x_vx", "cov_vy_vy"};
  const core::CsvTable table(directory.path() + "/tracks.csv", kColumns);
  ASSERT_EQ(table.num_rows(), 1u);
  EXPECT_EQ(table.text(0, "points"), "1 2 4 5");
  EXPECT_NEAR(table.number(0, "x_m"), 1500.0, 5.0);
  // Four plots of 10 m: the newest position is known to better than one of them, the velocity too.
  EXPECT_GT(table.number(0, "cov_x_x"), 0.0);
  EXPECT_LT(table.number(0, "cov_x_x"), 100.0);
  EXPECT_GT(table.number(0, "cov_x_vx"), 0.0);
  EXPECT_LT(table.number(0, "cov_vy_vy"), 2.0 * 100.0 / 4.0);  // That of the last two plots alone.
}

TEST(InitiateCommand, ScoresPointsThatNameTheirTargets) {
  const tests::TemporaryDirectory directory;
  ::testing::internal::CaptureStderr();
  initiate_command(options_of(directory.path(), write_points(directory.path())));
  const std::string log = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(log.find("1 of 1 targets with a true track (P2 1), 0 of 1 tracks false"), std::string::npos)
      << log;
}

TEST(InitiateCommand, RefusesANegativeTarget) {
  const tests::TemporaryDirectory directory;
  const std::string points = write_points(directory.path());
  std::ofstream(points, std::ios::app) << "4,8,2000,0,-1\n";
  EXPECT_THROW(initiate_command(options_of(directory.path(), points)), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
