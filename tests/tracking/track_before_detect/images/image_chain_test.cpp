#include "tracking/track_before_detect/images/image_chain.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/image_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(ImageChain, GivesOneListForEachImageBetweenTwoStates) {
  std::vector<std::int64_t> utimes;
  ImageChain chain(
      {}, "h_pmht", [&](const PingResult& result) { utimes.push_back(result.utime); },
      [](const std::string&) {});
  const auto pings = pings_of(sonar_scene("", 2.0), 1006);
  chain.add(core::VehicleState{pings.front().image.utime, {}, {0.0, 0.0}});
  for (const auto& ping : pings) {
    chain.add(ping.image);
    chain.add(core::VehicleState{ping.image.utime + 1, {}, {0.0, 0.0}});
  }
  chain.finish();
  ASSERT_EQ(utimes.size(), pings.size());
  for (std::size_t k = 0; k < pings.size(); ++k) EXPECT_EQ(utimes[k], pings[k].image.utime);
  EXPECT_EQ(chain.counts().accepted, static_cast<std::int64_t>(pings.size()));
}

TEST(ImageChain, AnImageWithoutAPoseIsRejected) {
  int lists = 0;
  ImageChain chain(
      {}, "h_pmht", [&](const PingResult&) { ++lists; }, [](const std::string&) {});
  chain.add(pings_of(sonar_scene("", 1.0), 1007).front().image);
  chain.finish();
  EXPECT_EQ(lists, 0);
  EXPECT_EQ(chain.counts().no_pose, 1);
}

TEST(ImageChain, AnElementIsATrackAtItsOwnTime) {
  core::Track track;
  track.state << 1.0, 2.0, 3.0, 4.0;
  track.existence = 0.75;
  const auto elements = as_elements({&track, 1}, 500);
  ASSERT_EQ(elements.size(), 1u);
  EXPECT_EQ(elements[0].initial_utime, 500);
  EXPECT_EQ(elements[0].initial_position, elements[0].position);
  EXPECT_EQ(elements[0].position, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(elements[0].velocity, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(elements[0].existence, 0.75);
}

}  // namespace
}  // namespace lookout::tracking
