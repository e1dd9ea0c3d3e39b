#include "core/files/stamp_checks.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "core/files/recording.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::core {
namespace {

using testing::error_of;

/// A recording whose scans.csv holds `rows` under its header.
class StampedRecording {
 public:
  explicit StampedRecording(const std::string& rows, const std::string& bearing = "bearing_rad") {
    folder_.write("vehicle.csv", "time_s,north_m,east_m,heading_rad\n0,0,0,0\n1,0,0,0\n");
    folder_.write("scans.csv", "time_s," + bearing + ",range_m,intensity\n" + rows);
  }
  void state_period(const std::string& seconds) {
    folder_.write("sonar.yaml", "scan_period: " + seconds + "\n");
  }
  Recording read() const { return read_recording(folder_.path()); }
  std::string error() const {
    const std::string text = error_of([&] { read(); });
    return text.substr(std::min(text.size(), folder_.path().size()));
  }
  std::string notes() const {
    std::string all;
    for (const auto& note : read().notes) all += note + "\n";
    return all;
  }

 private:
  tests::TemporaryDirectory folder_;
};

TEST(StampChecks, AnEmptyScanAmongReturnsMeansCutStamps) {
  EXPECT_EQ(
      StampedRecording("0,.1,5,1\n0,,,\n1,.1,5,1\n").error().find("/scans.csv:3: time_s: a scan without"),
      0u);
  EXPECT_EQ(StampedRecording("0,,,\n0,.1,5,1\n").error().find("/scans.csv:3: time_s: a scan without"), 0u);
  EXPECT_EQ(StampedRecording("0,,,\n1,.1,5,1\n").notes(), "");
}

TEST(StampChecks, TimesOfThirtyTwoBitFloatsAreRefused) {
  // Floats near 1.7e9 are 128 apart.
  EXPECT_EQ(StampedRecording("1700000000,.1,5,1\n1700000000,.2,5,1\n1700000128,.1,5,1\n")
                .error()
                .find("/scans.csv:4: time_s: every time is one of a 32-bit float"),
            0u);
  EXPECT_EQ(StampedRecording("1700000000,.1,5,1\n1700000001,.1,5,1\n").notes(), "");
}

TEST(StampChecks, TimesOfSixDigitsAreRefused) {
  EXPECT_EQ(StampedRecording("1.7e+09,.1,5,1\n1.7e+09,.2,5,1\n")
                .error()
                .find("/scans.csv:3: time_s: got `1.7e+09`"),
            0u);
}

TEST(StampChecks, WholeSecondsUnderAShorterStatedPeriodAreNoted) {
  StampedRecording recording("0,.1,5,1\n0,.2,5,1\n1,.1,5,1\n2,.1,5,1\n");
  EXPECT_EQ(recording.notes(), "");  // A period of one second is as likely.
  recording.state_period("1");
  EXPECT_EQ(recording.notes(), "");
  recording.state_period("0.7");  // Pings at 0, .7, 1.4, 2.1 s, two of them merged.
  EXPECT_NE(recording.notes().find("states scan_period 0.7 s"), std::string::npos);
  recording.state_period("0.25");
  EXPECT_NE(recording.notes().find("whole multiples of 1 s, but sonar.yaml states scan_period 0.25 s"),
            std::string::npos);
}

TEST(StampChecks, NanReturnsAreSilencesAndCounted) {
  const StampedRecording recording("0,nan,5,1\n0,.1,inf,1\n0,.1,5,1\n1,.1,NaN,1\n");
  EXPECT_EQ(recording.read().scans.at(0).returns.size(), 1u);
  EXPECT_EQ(recording.read().scans.at(1).returns.size(), 0u);
  EXPECT_NE(recording.notes().find("scans.csv:2: 3 of 4 rows have no finite bearing or range"),
            std::string::npos);
}

TEST(StampChecks, DegreesAreReadUnderTheirNameAndSuspectedUnderTheOther) {
  const StampedRecording degrees("0,90,5,1\n1,-90,5,1\n", "bearing_deg");
  EXPECT_NEAR(degrees.read().scans[0].returns[0].bearing, 1.5707963, 1e-7);  // pi / 2
  EXPECT_EQ(degrees.notes(), "");
  EXPECT_NE(StampedRecording("0,.1,5,1\n1,90,5,1\n")
                .notes()
                .find("scans.csv:3: 1 of 2 rows have a bearing_rad beyond"),
            std::string::npos);
}

// Beams to 45 degrees either side, as radians; a fan of degrees that is wider says nothing.
TEST(StampChecks, RadiansUnderTheNameOfDegreesAreSuspected) {
  std::string radians, usual;
  for (int k = 0; k < 60; ++k) {
    radians += "0," + std::to_string(0.78 - 0.026 * k) + ",5,1\n";
    usual += "0," + std::to_string(45.0 - 1.5 * k) + ",5,1\n";
  }
  const auto suspects = [](const std::string& rows, const std::string& column) {
    return StampedRecording(rows, column).notes().find("name the column bearing_rad") != std::string::npos;
  };
  EXPECT_TRUE(suspects(radians, "bearing_deg"));
  EXPECT_FALSE(suspects(usual, "bearing_deg"));
  EXPECT_FALSE(suspects(radians, "bearing_rad"));
}

TEST(StampChecks, AnIdentityTwiceAtOneTimeIsRefused) {
  const tests::TemporaryDirectory folder;
  const auto path = folder.write("truth.csv", "time_s,id,north_m,east_m\n0,1,0,0\n0,1,5,0\n");
  EXPECT_EQ(error_of([&] { read_truth(path); }).find(path + ":3: id: stands twice at 0 s"), 0u);
}

// Two pings a second in whole seconds: each beam stands twice, and the bearings go back.
TEST(StampChecks, SeveralScansOfOneTimeAreToldWithTheFirstLine) {
  std::ostringstream merged, ordered, fine;
  for (int k = 0; k < 6; ++k) {
    merged << k << ",-.2,5,1\n" << k << ",.1,9,1\n" << k << ",-.2,5.1,1\n" << k << ",.1,9.1,1\n";
    ordered << k << ",-.2,5,1\n" << k << ",-.2,5.1,1\n" << k << ",.1,9,1\n" << k << ",.1,9.1,1\n";
    const std::string exact = std::to_string(k).append(".00000").append(std::to_string(k * k % 10));
    fine << exact << ",-.2,5,1\n" << exact << ",.1,9,1\n" << exact << ",-.2,5.1,1\n";
  }
  EXPECT_NE(StampedRecording(merged.str())
                .notes()
                .find("scans.csv:2: 6 of 6 times hold two returns of one beam, not in order"),
            std::string::npos)
      << StampedRecording(merged.str()).notes();
  EXPECT_EQ(StampedRecording(ordered.str()).notes(),
            "");  // One scan of two returns a beam, as programs write it.
  EXPECT_EQ(StampedRecording(fine.str()).notes(), "");  // Of a clock of microseconds: nothing was cut.
}

TEST(StampChecks, AnotherSequenceAtOneTimeIsRefused) {
  const tests::TemporaryDirectory folder;
  folder.write("scans.csv", "time_s,sequence,bearing_rad,range_m\n0,0,.1,5\n0,0,.2,5\n0,1,.1,5\n");
  EXPECT_NE(error_of([&] { read_recording(folder.path()); }).find("scans.csv:4: sequence: is another than"),
            std::string::npos);
}

}  // namespace
}  // namespace lookout::core
