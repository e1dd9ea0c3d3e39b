#include "tracking/node/tracker_node.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/input_error.hpp"
#include "tests/tracking/track_before_detect/image_scene.hpp"

namespace lookout::tracking {
namespace {

std::unique_ptr<ImageChain> h_pmht(ImageChain::OnResult on_result, ImageChain::Report report) {
  return std::make_unique<ImageChain>(core::SonarParams(), "h_pmht", std::move(on_result), std::move(report));
}

TEST(ImageTrackerNode, PublishesEachResultOnceForEachImage) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.node_id = 3;
  params.publish_estimates = true;
  ImageTrackerNode node(bus, params, &h_pmht, [](const std::string&) {});
  std::vector<lcmtypes::KeyedTracks> lists;
  std::vector<lcmtypes::KeyedElements> elements;
  std::size_t estimates = 0;
  bus.subscribe<track_list_t>("TRACKS", [&](lcmtypes::KeyedTracks tracks) { lists.push_back(tracks); });
  bus.subscribe<motion_elements_t>("MOTION_ELEMENTS",
                                   [&](lcmtypes::KeyedElements list) { elements.push_back(list); });
  bus.subscribe<local_estimate_t>("LOCAL_ESTIMATE", [&](const core::LocalEstimate& estimate) {
    ++estimates;
    EXPECT_EQ(estimate.node_id, 3);
  });
  // Both move: what stands is background.
  const std::string targets =
      "  - {id: 1, north: 60.0, east: 0.0, north_velocity: -1.0}\n"
      "  - {id: 2, north: 90.0, east: 20.0, east_velocity: 1.0}\n";
  const auto pings = pings_of(sonar_scene(targets, 8.0, 20.0), 1008);
  bus.publish("VEHICLE_STATE",
              lcmtypes::to_wire(core::VehicleState{pings.front().image.utime, {}, {0.0, 0.0}}));
  for (const auto& ping : pings) {
    bus.publish("SONAR_IMAGE", lcmtypes::to_wire(ping.image));
    bus.publish("VEHICLE_STATE", lcmtypes::to_wire(core::VehicleState{ping.image.utime + 1, {}, {0.0, 0.0}}));
  }
  node.run({.idle_exit = 0.05});
  bus.drain();
  ASSERT_EQ(lists.size(), pings.size());
  ASSERT_EQ(elements.size(), pings.size());
  EXPECT_EQ(elements.back().method, core::EstimatorMethod::h_pmht);
  EXPECT_EQ(std::count_if(lists.back().tracks.begin(), lists.back().tracks.end(),
                          [](const auto& track) { return track.status == core::TrackStatus::confirmed; }),
            2);
  // Two tracks, but a link of 256 bytes a second: one message of 109 bytes a ping of half a second at most.
  EXPECT_GT(estimates, 0u);
  EXPECT_LE(estimates, pings.size());
  EXPECT_LE(node.link().most_bytes_in_a_second(), 256);
}

TEST(ImageTrackerNode, RefusesTheNodeIdOfProgramsThatTrackNothing) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.node_id = 0;
  EXPECT_THROW(ImageTrackerNode(bus, params, &h_pmht, [](const std::string&) {}), core::InputError);
}

}  // namespace
}  // namespace lookout::tracking
