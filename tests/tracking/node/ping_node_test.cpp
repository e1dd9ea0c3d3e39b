#include "tracking/node/ping_node.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "lcmtypes/convert_reports.hpp"

namespace lookout::tracking {
namespace {

TEST(PingNode, TracksComeLastAndEstimatesWithinTheLinksRate) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.channel_prefix = "AUV1_";
  params.publish_estimates = true;
  PingNode output(bus, params, [](const std::string&) {});
  std::vector<std::string> heard;
  bus.subscribe<motion_elements_t>("AUV1_MOTION_ELEMENTS", [&](const auto&) { heard.push_back("elements"); });
  bus.subscribe<sensor_estimate_t>("AUV1_SENSOR_ESTIMATE", [&](const auto&) { heard.push_back("sensor"); });
  bus.subscribe<local_estimate_t>("LOCAL_ESTIMATE", [&](const auto&) { heard.push_back("estimate"); });
  bus.subscribe<track_list_t>("AUV1_TRACKS", [&](const auto&) { heard.push_back("tracks"); });
  std::vector<core::Track> tracks(3);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].id = static_cast<std::int64_t>(i) + 1;
    tracks[i].status = core::TrackStatus::confirmed;
  }
  PingResult result;
  result.utime = 500'000;
  result.sequence = 1;
  result.sensor_id = 9;
  result.tracks = tracks;
  result.sensor_estimate = core::SensorEstimate{};
  output.publish(result);
  bus.drain();
  // Three confirmed tracks; the link has saved up one message.
  EXPECT_EQ(heard, (std::vector<std::string>{"elements", "sensor", "estimate", "tracks"}));
  EXPECT_EQ(output.link().messages_sent(), 1);
}

// Asked for every second of data, at two pings a second: the first of each second, behind its tracks.
TEST(PingNode, PublishesTheClutterMapNowAndThenBehindTheTracks) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.clutter_every = 1.0;
  PingNode output(bus, params, [](const std::string&) {});
  std::vector<std::string> heard;
  bus.subscribe<track_list_t>("TRACKS", [&](const auto&) { heard.push_back("tracks"); });
  bus.subscribe<clutter_map_t>("CLUTTER_MAP", [&](const core::ClutterGrid& grid) {
    heard.push_back("clutter of " + std::to_string(grid.sensor_id));
  });
  PingResult result;
  result.clutter_grid = [] { return core::ClutterGrid{0, 9, {}, -0.5, 0.1, 1.0, 1, 1, {20}}; };
  for (const std::int64_t utime : {0, 500'000, 1'000'000, 400'000}) {  // The last is of a new clock.
    result.utime = utime;
    output.publish(result);
  }
  bus.drain();
  EXPECT_EQ(heard, (std::vector<std::string>{"tracks", "clutter of 9", "tracks", "tracks", "clutter of 9",
                                             "tracks", "clutter of 9"}));
}

TEST(PingNode, PublishesWhatWasDecidedBehindTheTracksAndOnce) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.node_id = 3;
  params.decisions = std::make_shared<std::string>();
  PingNode node(bus, params, [](const std::string& /*line*/) {});
  std::vector<std::string> heard;
  bus.subscribe_bytes("TRACKS",
                      [&](std::span<const std::uint8_t> /*bytes*/) { heard.emplace_back("tracks"); });
  bus.subscribe_bytes("DECISIONS", [&](std::span<const std::uint8_t> bytes) {
    const auto report = lcmtypes::read_decisions(bytes);
    heard.push_back(std::to_string(report->source_id) + " " + std::to_string(report->text.size()));
  });
  PingResult result;
  *params.decisions = "1.000 s track 4: begin, 4.0 nats, a reason\n";
  node.publish(result);
  node.publish(result);
  const std::string line(100, 'x');
  for (int k = 0; k < 400; ++k) *params.decisions += line + "\n";  // 40,400 characters: 297 lines, then 103.
  node.publish(result);
  bus.drain();
  EXPECT_EQ(heard, (std::vector<std::string>{"tracks", "3 43", "tracks", "tracks", "3 29997", "3 10403"}));
}

TEST(PingNode, PublishesNoClutterMapUnasked) {
  lcmtypes::Bus bus("memq://");
  PingNode output(bus, {}, [](const std::string&) {});
  PingResult result;
  result.clutter_grid = []() -> std::optional<core::ClutterGrid> { throw std::logic_error("asked for"); };
  output.publish(result);
}

TEST(PingNode, TellsAPersonWhatItNotes) {
  lcmtypes::Bus bus("memq://");
  std::vector<std::string> lines;
  PingNode output(bus, {}, [&](const std::string& line) { lines.push_back(line); });
  output.note("a line");
  EXPECT_EQ(lines, std::vector<std::string>{"a line"});
}

TEST(PingNode, RefusesABadPrefix) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.channel_prefix = "with space ";
  EXPECT_THROW(PingNode(bus, params, [](const std::string&) {}), core::InputError);
}

}  // namespace
}  // namespace lookout::tracking
