#include "tools/watch/status_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "lcmtypes/bus.hpp"
#include "tests/tools/watch/watch_examples.hpp"
#include "tools/watch/listen.hpp"

namespace lookout::tools {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StatusText, OfAHealthyChainShowsRatesLatencyAndTracks) {
  Heard heard("");
  say_healthy(heard, 11);
  const std::string text = status_text(heard, at_second(5.1));
  EXPECT_TRUE(has(text, "lookout status: HEALTHY")) << text;
  EXPECT_TRUE(has(text, "SONAR_SCAN                    2.00     0.1 s         11       0       0")) << text;
  EXPECT_TRUE(has(text, "lookout track 1               0.00     12.50          5       0       0")) << text;
  EXPECT_TRUE(has(text, "tracks: 1 confirmed, 0 tentative, 0 coasting at 5.0 s")) << text;
}

TEST(StatusText, SaysWhyItIsNotHealthyFromABus) {
  lcmtypes::Bus bus("memq://");
  Heard heard("");
  listen(bus, heard);
  bus.publish("SONAR_SCAN", lcmtypes::to_wire(tests::example_scan()));
  bus.drain();
  const std::string text = status_text(heard, Heard::Clock::now());
  EXPECT_TRUE(has(text, "lookout status: NOT HEALTHY\n  ! no VEHICLE_STATE heard\n  ! no TRACKS heard\n"))
      << text;
}

TEST(StatusText, WhereNothingIsHeardEveryReasonIsShown) {
  const std::string text = status_text(Heard(""), at_second(100.0));
  EXPECT_TRUE(has(text, "  ! no SONAR_SCAN heard\n")) << text;
  EXPECT_TRUE(has(text, "  ! no tracker heard on LOOKOUT_STATUS; start `lookout track` or check --lcm-url\n"))
      << text;
  EXPECT_FALSE(has(text, "more\n")) << text;
}

TEST(StatusText, PrintedOnceSaysEveryReasonInFull) {
  Heard heard("");
  for (int id = 1; id <= 6; ++id) {  // More than a screen shows.
    node_status_t status = tracker_status();
    status.node_id = id;
    status.last_error = "degraded: " + std::string(100, 'x') + " end";
    say(heard, "LOOKOUT_STATUS", status);
  }
  const std::string text = status_text(heard, at_second(5.1), Reasons::whole);
  for (int id = 1; id <= 6; ++id) {
    const std::string reason = "  ! lookout track " + std::to_string(id) + ": degraded: ";
    EXPECT_TRUE(has(text, reason + std::string(100, 'x') + " end\n")) << text;
  }
  EXPECT_FALSE(has(text, "  ! and ")) << text;
}

TEST(StatusText, FitsOneScreenWhateverCame) {
  Heard heard("A_prefix_of_30_characters_long");
  std::vector<core::Track> tracks(300, tests::example_track(1));
  const std::string prefix = "A_prefix_of_30_characters_long";
  say(heard, prefix + "TRACKS", lcmtypes::to_wire({0, 0, 0}, tracks).message);
  say(heard, prefix + "SONAR_IMAGE", lcmtypes::to_wire(tests::example_image()));
  for (int id = 1; id < 20; ++id) {
    node_status_t status = tracker_status();
    status.node_id = id;
    status.last_error = std::string(500, 'x');
    say(heard, prefix + "LOOKOUT_STATUS", status);
  }
  const std::string text = status_text(heard, at_second(100.0));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24) << text;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

}  // namespace
}  // namespace lookout::tools
