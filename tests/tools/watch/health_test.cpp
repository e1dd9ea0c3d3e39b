#include "tools/watch/health.hpp"

#include <gtest/gtest.h>

#include "tests/tools/watch/watch_examples.hpp"

namespace lookout::tools {
namespace {

bool says(const std::vector<std::string>& lines, const std::string& part) {
  for (const auto& line : lines) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(Complaints, OfAHealthyChainThereAreNone) {
  Heard heard("");
  say_healthy(heard, 11);
  EXPECT_EQ(complaints(heard, at_second(5.1)), std::vector<std::string>{});
}

TEST(Complaints, NameWhatIsSilent) {
  Heard heard("");
  EXPECT_TRUE(says(complaints(heard, at_second(0.0)), "no SONAR_SCAN heard"));
  EXPECT_TRUE(says(complaints(heard, at_second(0.0)), "no tracker heard"));
  say_healthy(heard, 11);
  const auto lines = complaints(heard, at_second(15.0));
  EXPECT_TRUE(says(lines, "no SONAR_SCAN for 10.0 s"));  // The last at 5 s.
  EXPECT_TRUE(says(lines, "no TRACKS for 10.0 s"));
  EXPECT_TRUE(says(lines, "lookout track 1: silent for 10.0 s"));
}

TEST(Complaints, LetASlowSonarBeSlow) {
  Heard heard("");
  for (int k = 0; k < 2; ++k) {
    core::SonarScan scan = tests::example_scan();
    scan.sequence = k;
    say(heard, "SONAR_SCAN", lcmtypes::to_wire(scan), 20.0 * k);
  }
  EXPECT_FALSE(says(complaints(heard, at_second(39.0)), "no SONAR_SCAN"));
  EXPECT_TRUE(says(complaints(heard, at_second(81.0)), "no SONAR_SCAN"));  // More than three periods of 20 s.
}

TEST(Complaints, TellLossesRefusalsAndSlowness) {
  Heard heard("");
  say_healthy(heard, 11);
  core::SonarScan scan = tests::example_scan();
  scan.sequence = 20;
  say(heard, "SONAR_SCAN", lcmtypes::to_wire(scan), 5.1);
  node_status_t status = tracker_status(4);
  status.latency_ms_p99 = 900.0;
  status.last_error = "no pose";
  say(heard, "LOOKOUT_STATUS", status, 5.1);
  const auto lines = complaints(heard, at_second(5.2));
  EXPECT_TRUE(says(lines, "SONAR_SCAN: 9 lost on the way to here of 21"));  // 11 to 19, of 0 to 20.
  EXPECT_TRUE(says(lines, "refused 4 messages while watched, last: no pose"));
  EXPECT_TRUE(says(lines, "p99 latency 900 ms is above the 464 ms between pings"));  // 5.1 s / 11.
}

}  // namespace
}  // namespace lookout::tools
