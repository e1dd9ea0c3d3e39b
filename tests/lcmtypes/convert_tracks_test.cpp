#include "lcmtypes/convert.hpp"

#include <gtest/gtest.h>

#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

using namespace lookout::tests;

TEST(ConvertTracks, ElementsThereAndBack) {
  const auto back = to_core(example_wire(static_cast<const motion_elements_t*>(nullptr))).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key.sequence, 4);
  EXPECT_EQ(back->method, core::EstimatorMethod::sht);
  EXPECT_EQ(back->window_scans, 20);
  ASSERT_EQ(back->elements.size(), 2u);
  const auto& element = back->elements[0];
  EXPECT_EQ(element.initial_utime, 1'000'000);
  EXPECT_EQ(element.initial_position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(element.state(), Eigen::Vector4d(5, 6, 3, 4));
  EXPECT_EQ(element.covariance, example_element().covariance);
  EXPECT_EQ(element.score, 7.0);
  EXPECT_EQ(element.existence, 0.5);
  EXPECT_EQ(element.support, 8);
}

TEST(ConvertTracks, AMethodFromOutsideGoesThereAndBackAndAnUnknownNumberDoesNot) {
  auto wire = to_wire(kExampleKey, core::EstimatorMethod::other, 20, {}).message;
  EXPECT_EQ(wire.method, 127);  // lcmtypes/motion_elements_t.lcm
  EXPECT_EQ(to_core(wire).value->method, core::EstimatorMethod::other);
  for (const int unknown : {-1, 6, 126}) {
    wire.method = static_cast<std::int8_t>(unknown);
    EXPECT_FALSE(to_core(wire).value) << unknown;
  }
}

TEST(ConvertTracks, TracksThereAndBack) {
  const auto back = to_core(example_wire(static_cast<const track_list_t*>(nullptr))).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key.utime, 2'000'000);
  EXPECT_EQ(back->key.source_id, 7);
  ASSERT_EQ(back->tracks.size(), 2u);
  const auto& track = back->tracks[1];
  EXPECT_EQ(track.id, 2);
  EXPECT_EQ(track.status, core::TrackStatus::coasting);
  EXPECT_EQ(track.state, Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_EQ(track.covariance, example_track(2).covariance);
  EXPECT_EQ(track.existence, 0.75);
  EXPECT_EQ(track.first_utime, 500'000);
  EXPECT_EQ(track.last_detection_utime, 1'500'000);
}

TEST(ConvertTracks, ALongListKeepsItsMostProbableInTheirOrder) {
  std::vector<core::Track> tracks;
  for (int id = 0; id < 302; ++id) tracks.push_back(example_track(id, 0.5));
  tracks[0].existence = 0.1;
  tracks[150].existence = 0.2;
  const auto listed = to_wire(kExampleKey, tracks);
  EXPECT_EQ(listed.left_out, 2u);
  ASSERT_EQ(listed.message.tracks.size(), 300u);
  EXPECT_EQ(listed.message.tracks.front().id, 1);
  EXPECT_EQ(listed.message.tracks[149].id, 151);
  EXPECT_EQ(listed.message.tracks.back().id, 301);
}

}  // namespace
}  // namespace lookout::lcmtypes
