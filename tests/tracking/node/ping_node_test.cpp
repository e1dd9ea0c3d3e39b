#include "tracking/node/ping_node.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

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
