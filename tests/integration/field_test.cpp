// Sensors of other paces and scales than the ones that a configuration would name, replayed from logs without
// one: what a message cannot carry has to come from the stream.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "core/random.hpp"
#include "lcmtypes/convert.hpp"
#include "lcmtypes/log_writer.hpp"
#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A dive before two targets and a false return a scan, at a detection probability of .95.
struct Dive {
  int num_scans = 40;
  double period = 1.0;         ///< Of scans [s].
  double per_second = 1e6;     ///< Units of a stamp.
  double max_range = 100.0;    ///< [m]; the targets are at .4 and .6 of it.
  double range_sigma = 0.3;    ///< [m].
  double step_deg = 2.0;       ///< Between 60 beams.
  double walk = 0.2;           ///< What a target goes in a second [m].
  double other_range = 100.0;  ///< Of every other scan [m].
};

/// The log that lcm-logger would have written.
class DiveLog {
 public:
  DiveLog(const Dive& dive, const std::string& path) : dive_(dive), log_(path) {
    for (int k = 0; k < dive.num_scans; ++k) add(k);
    log_.close();
  }

 private:
  void add(int k) {
    const double time = k * dive_.period;
    const auto heard = static_cast<std::int64_t>(time * 1e6);
    core::SonarScan scan;
    scan.utime = static_cast<std::int64_t>(std::llround(time * dive_.per_second));
    scan.sequence = k;
    scan.num_beams = 60;
    scan.bearing_step = dive_.step_deg * kDegree;
    scan.first_bearing = -29.5 * scan.bearing_step;
    scan.max_range = k % 2 == 0 ? dive_.max_range : std::max(dive_.max_range, dive_.other_range);
    echo(scan, 0.4 * dive_.max_range - 0.8 * dive_.walk * time, 0.1 * dive_.max_range);
    echo(scan, 0.6 * dive_.max_range, -0.2 * dive_.max_range + 0.8 * dive_.walk * time);
    scan.returns.push_back({beam(scan, random_.index(60)), dive_.max_range * random_.uniform(0.0, 1.0), 1.0});
    log_.add("VEHICLE_STATE", heard, lcmtypes::to_wire(core::VehicleState{scan.utime, {}, {0.0, 0.0}}));
    log_.add("SONAR_SCAN", heard, lcmtypes::to_wire(scan));
  }
  static double beam(const core::SonarScan& scan, int number) {
    return scan.first_bearing + number * scan.bearing_step;
  }
  void echo(core::SonarScan& scan, double north, double east) {
    const auto number = std::lround((std::atan2(east, north) - scan.first_bearing) / scan.bearing_step);
    if (random_.uniform(0.0, 1.0) > 0.95 || number < 0 || number >= 60) return;
    const double range = std::hypot(north, east) + random_.gaussian(dive_.range_sigma);
    scan.returns.push_back({beam(scan, static_cast<int>(number)), range, 1.0});
  }

  Dive dive_;
  core::Random random_{16};
  lcmtypes::LogWriter log_;
};

class Field : public ::testing::Test {
 protected:
  ProgramResult replay(const Dive& dive, const std::string& flags = "") {
    const DiveLog log(dive, folder_.file("log"));
    const auto result =
        run_lookout("replay " + folder_.file("log") + " --out " + folder_.file("out") + " " + flags);
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }
  /// Identities that are confirmed for `scans` at least.
  int long_lives(int scans) const {
    std::map<std::string, int> rows;
    std::istringstream text(text_of(folder_.file("out/tracks.csv")));
    for (std::string line; std::getline(text, line);)
      if (line.find(",confirmed,") != std::string::npos) {
        const std::size_t id = line.find(',') + 1;
        ++rows[line.substr(id, line.find(',', id) - id)];
      }
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [scans](const auto& row) { return row.second >= scans; }));
  }
  static int lines_with(const ProgramResult& result, const std::string& what) {
    int count = 0;
    for (auto at = result.err.find(what); at != std::string::npos; at = result.err.find(what, at + 1))
      ++count;
    return count;
  }

  TemporaryDirectory folder_;
};

// From 6 s on nothing was tracked, with no word. No message carries a period.
TEST_F(Field, SlowSonarsAreTrackedAtTheirOwnPaceAndThatIsSaid) {
  for (const double period : {2.0, 6.0, 30.0, 60.0}) {
    const auto result = replay({.period = period, .walk = 0.4 / period});
    EXPECT_EQ(long_lives(30), 2) << period << "\n" << result.err;
    EXPECT_EQ(lines_with(result, "tracking goes by that"), 1) << result.err;
    EXPECT_EQ(lines_with(result, "new clock"), 0) << result.err;
    const auto again = run_lookout("replay " + folder_.file("out") + " --out " + folder_.file("again"));
    EXPECT_EQ(text_of(folder_.file("out/tracks.csv")), text_of(folder_.file("again/tracks.csv")))
        << period << "\n"
        << again.err;
  }
}

TEST_F(Field, ATurnOfAHundredSecondsLosesNoScan) {
  const auto result = replay({.period = 100.0, .walk = 0.004});
  const auto counts = nlohmann::json::parse(text_of(folder_.file("out/summary.json")))["received"];
  EXPECT_EQ(counts["tracked"], counts["scans"]) << result.err;
  EXPECT_EQ(long_lives(30), 2) << result.err;
}

TEST_F(Field, FastSonarsAreTrackedWithoutAWord) {
  const auto result = replay({.num_scans = 100, .period = 0.05, .walk = 0.6});
  EXPECT_EQ(long_lives(80), 2) << result.err;
  EXPECT_EQ(lines_with(result, "tracking goes by that"), 0) << result.err;
}

// A sigma of 3 m is that of a sonar of 150 m: at 5 m nothing was tracked, with no word.
TEST_F(Field, AnImagingSonarIsTrackedWithoutItsFigures) {
  const auto result =
      replay({.num_scans = 100, .period = 0.05, .max_range = 5.0, .range_sigma = 0.02, .walk = 0.3});
  EXPECT_EQ(long_lives(80), 2) << result.err;
  EXPECT_EQ(lines_with(result, "range_sigma 3 m in a range of 5 m: 0.1 m is taken"), 1) << result.err;
}

// A beam is 430 m wide there: targets of which all was sure but the place were not reported for a minute.
TEST_F(Field, AFarSensorReportsTargetsThatAreAsUncertainAsItsBeams) {
  const auto config = folder_.write("far.yaml", "sensor: {range_sigma: 20, max_speed: 15, scan_period: 5}\n");
  const auto result =
      replay({.period = 5.0, .max_range = 25e3, .range_sigma = 20.0, .step_deg = 1.0, .walk = 8.0},
             "--config " + config);
  EXPECT_EQ(long_lives(30), 2) << result.err;
}

TEST_F(Field, StampsInMillisecondsAreToldAtAnyPace) {
  for (const double period : {1.0, 10.0, 30.0})
    EXPECT_EQ(lines_with(replay({.period = period, .per_second = 1e3, .walk = 0.01}),
                         "stamps go 1000 times slower than the log's own clock"),
              1)
        << period;
}

TEST_F(Field, AGeometryThatAlwaysChangesMakesNoStreamOfLines) {
  EXPECT_LE(lines_with(replay({.num_scans = 200, .other_range = 150.0}), "another geometry"), 13);
}

TEST_F(Field, APipeIntoWhichNobodyWritesIsRefusedForEveryInput) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  ASSERT_EQ(std::system(("mkdir " + folder_.file("d")).c_str()), 0);
  ASSERT_EQ(mkfifo(folder_.file("d/scans.csv").c_str(), 0600), 0);
  for (const std::string& arguments :
       {"replay " + folder_.file("d") + " --out " + folder_.file("o"), "ospa " + pipe + " " + pipe}) {
    const auto result = run_lookout(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_NE(result.err.find("is a pipe into which nobody writes"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace lookout::tests
