#include "fusion/methods/mutual_support_fusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::group;
using testing::tracklet;

double fused_east(MutualSupport variant, const std::vector<LocalTrack>& tracks) {
  MutualSupportFusion method(variant);
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  return method.fuse(groups).front().state.y();
}

/// East 0, 1 and 10 m.
const std::vector<LocalTrack> kTwoAgree{tracklet(1, {0, 0, 1, 0}), tracklet(2, {0, 1, 1, 0}),
                                        tracklet(3, {0, 10, 1, 0})};

TEST(MutualSupportFusion, RowSumsByHand) {
  // r = 1 - d/10: rows 1 + 0.9 + 0, 0.9 + 1 + 0.1, 0 + 0.1 + 1; sum 5.
  EXPECT_NEAR(fused_east(MutualSupport::b, kTwoAgree), (2.0 * 1.0 + 1.1 * 10.0) / 5.0, 1e-12);
}

TEST(MutualSupportFusion, EigenvectorIsHarsherThanRowSums) {
  // By hand: r v = l v with r as above has l = 1 + sqrt(0.82) and v = (0.9, l - 1, 0.1).
  const double middle = std::sqrt(0.82);
  EXPECT_NEAR(fused_east(MutualSupport::a, kTwoAgree), (middle + 0.1 * 10.0) / (0.9 + middle + 0.1), 1e-9);
}

TEST(MutualSupportFusion, SupportFromThePrediction) {
  // 1 - d/10 against the prediction at 0: 1, 0.9, 0.
  EXPECT_NEAR(fused_east(MutualSupport::c, kTwoAgree), 0.9 / 1.9, 1e-12);
}

TEST(MutualSupportFusion, ExponentialRowSumsByHand) {
  const double mean = 2.0 * (1.0 + 9.0 + 10.0) / 9.0;
  const double a = std::exp(-1.0 / mean), b = std::exp(-9.0 / mean), c = std::exp(-10.0 / mean);
  const double sums[] = {1 + a + c, 1 + a + b, 1 + b + c};
  EXPECT_NEAR(fused_east(MutualSupport::d, kTwoAgree),
              (sums[1] + 10.0 * sums[2]) / (sums[0] + sums[1] + sums[2]), 1e-12);
}

TEST(MutualSupportFusion, EqualWeightsWhereAllAgreeAndOfOneOrTwo) {
  for (const auto variant : {MutualSupport::a, MutualSupport::b, MutualSupport::d}) {
    EXPECT_NEAR(fused_east(variant, {tracklet(1, {0, 3, 1, 0}), tracklet(2, {0, 3, 1, 0})}), 3.0, 1e-12);
    EXPECT_NEAR(fused_east(variant, {tracklet(1, {0, 3, 1, 0})}), 3.0, 1e-12);
    EXPECT_NEAR(fused_east(variant, {tracklet(1, {0, 2, 1, 0}), tracklet(2, {0, 4, 1, 0})}), 3.0, 1e-12);
  }
  EXPECT_NEAR(fused_east(MutualSupport::c, {tracklet(1, {0, 0, 1, 0}), tracklet(2, {0, 0, 1, 0})}), 0.0,
              1e-12);
}

}  // namespace
}  // namespace lookout::fusion
