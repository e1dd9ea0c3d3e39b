#include "sonar_sim/video_stand_in.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::sonar_sim {
namespace {

TEST(VideoStandIn, TheUnitSilhouetteHasItsArea) {
  constexpr int kCells = 1000;
  int covered = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j)
      covered +=
          silhouette_covers({-0.6 + 1.2 * (i + 0.5) / kCells, -0.6 + 1.2 * (j + 0.5) / kCells}) ? 1 : 0;
  EXPECT_NEAR(covered * 1.44 / (kCells * kCells), 0.175, 0.009);  // the specification's, to 5 %
}

TEST(VideoStandIn, EveryScenarioStaysInItsFrame) {
  for (const VideoScenario& scenario : video_scenarios())
    for (std::uint64_t seed = 1000; seed < 1003; ++seed) {
      core::Random random(seed);
      const VideoStandIn video(scenario, plain_video(), random);
      const double half = 0.5 * std::sqrt(scenario.area / 0.175);
      for (int k = 0; k < video.num_samples(); ++k) {
        EXPECT_GT(video.position(k).minCoeff(), half - 6.0) << scenario.number;
        EXPECT_LT(video.position(k).maxCoeff(), scenario.size - half + 6.0) << scenario.number;
      }
    }
}

TEST(VideoStandIn, TheAircraftIsDarkWhereItsBoxSays) {
  core::Random random(1000);
  const VideoScenario& scenario = video_scenarios()[6];
  const VideoStandIn video(scenario, plain_video(), random);
  const VideoSample sample = video.render(10, random);
  const auto at = [&](int column, int row) {
    return sample.grey[static_cast<std::size_t>(row * scenario.size + column)];
  };
  const auto centre = video.position(10);
  EXPECT_LT(at(static_cast<int>(centre.x()), static_cast<int>(centre.y())),
            100.0);  // 200 less a contrast of 164
  EXPECT_GT(at(5, 20), 180.0);
  EXPECT_TRUE(sample.box.contains(sample.centroid));
  // New cells lie ahead of the centroid.
  EXPECT_GT((sample.new_centroid - sample.centroid).dot(video.velocity(10)), 0.0);
}

TEST(VideoStandIn, VelocityIsTheDerivativeOfThePath) {
  core::Random random(1001);
  const VideoStandIn video(video_scenarios()[0], plain_video(), random);
  const Eigen::Vector2d difference = (video.position(11) - video.position(9)) / (2.0 * 4.0);
  EXPECT_LT((difference - video.velocity(10)).norm(), 0.01);
}

TEST(VideoStandIn, TheSameSeedRepeats) {
  core::Random a(7), b(7);
  const VideoStandIn first(video_scenarios()[3], hard_video(), a),
      second(video_scenarios()[3], hard_video(), b);
  EXPECT_EQ(first.render(3, a).grey, second.render(3, b).grey);
}

TEST(VideoStandIn, RefusesParametersOutOfRange) {
  core::Random random(1);
  for (double VideoStandInParams::*const field :
       {&VideoStandInParams::jitter, &VideoStandInParams::sway, &VideoStandInParams::max_heading,
        &VideoStandInParams::mover_offset}) {
    VideoStandInParams params;
    params.*field = -1.0;
    EXPECT_THROW(VideoStandIn(video_scenarios()[0], params, random), std::invalid_argument);
  }
}

}  // namespace
}  // namespace lookout::sonar_sim
