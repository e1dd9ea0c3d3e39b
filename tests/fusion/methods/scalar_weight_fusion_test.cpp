#include "fusion/methods/scalar_weight_fusion.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::group;
using testing::tracklet;

TEST(ScalarWeightFusion, NormaliseScalesToOneAndSurvivesNought) {
  std::vector<double> support{1.0, 3.0}, nought{0.0, 0.0};
  normalise(support);
  normalise(nought);
  EXPECT_EQ(support, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(nought, (std::vector<double>{0.5, 0.5}));
}

TEST(ScalarWeightFusion, MeanIsTheMeanOfAllFourComponents) {
  const std::vector<LocalTrack> tracks{tracklet(1, {0, 2, 1, 5}), tracklet(2, {4, 4, 3, 5})};
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  MeanFusion method;
  EXPECT_EQ(method.fuse(groups).front().state, Eigen::Vector4d(2, 3, 2, 5));
}

TEST(ScalarWeightFusion, SingleNodeIsThatOfTheLowestId) {
  const std::vector<LocalTrack> tracks{tracklet(7, {0, 2, 1, 5}), tracklet(2, {4, 4, 3, 5})};
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  SingleNode method;
  EXPECT_EQ(method.fuse(groups).front().state, Eigen::Vector4d(4, 4, 3, 5));
}

}  // namespace
}  // namespace lookout::fusion
