#include "fusion/methods/maximum_likelihood_fusion.hpp"

#include <gtest/gtest.h>

#include "fusion/methods/covariance_fusion.hpp"
#include "tests/fusion/filter_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::fuse;
using testing::message;
using testing::Node;
using testing::with_covariance;

TEST(MaximumLikelihoodFusion, OfOneNodeIsThatNode) {
  MaximumLikelihoodFusion method({});
  const auto fused = fuse(method, {with_covariance(1, {3, 4, 1, 0}, 2.0, 5.0)});
  EXPECT_NEAR((fused.state - Eigen::Vector4d(3, 4, 1, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(fused.covariance(1, 1), 5.0, 1e-9);
}

TEST(MaximumLikelihoodFusion, IsBetweenTheSingleNodeAndTheSumThatForgetsTheCrossTerms) {
  const std::vector<LocalTrack> tracks{with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0),
                                       with_covariance(2, {1, 1, 1, 0}, 2.0, 2.0)};
  MaximumLikelihoodFusion method({0.5, 3.0});
  CovarianceFusion sum(CovarianceWeights::sum, 0.5);
  const double variance = fuse(method, tracks).covariance(0, 0);
  EXPECT_LT(variance, 2.0);
  EXPECT_GT(variance, fuse(sum, tracks).covariance(0, 0));  // The shared process noise is not halved.
}

TEST(MaximumLikelihoodFusion, TwoLongKnownTracksThatAreFirstFusedLateAreNotTakenForNewborn) {
  // Their first estimates are no longer kept: with the velocity prior of 300 m/s as common error the joint
  // covariance of two settled filters is not positive, and the fused state lands far outside of both.
  const KalmanModel model{1.0, 300.0};
  std::vector<LocalTrack> tracks;
  std::vector<Node> nodes{{100.0}, {400.0}};
  for (int k = 0; k < 12; ++k) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector2d z(10.0 * k, i == 0 ? 5.0 : -15.0);  // One sigma off to either side.
      if (k == 0) {
        nodes[i].start(z, model.velocity_sigma);
        tracks.emplace_back(message(nodes[i], static_cast<std::int32_t>(i) + 1, k));
      } else {
        nodes[i].predict(model);
        nodes[i].correct(z, nodes[i].r);
        tracks[i].append(message(nodes[i], static_cast<std::int32_t>(i) + 1, k));
      }
    }
  }
  MaximumLikelihoodFusion method(model);
  TrackGroup late{1, core::microseconds(11.0), false, {}, {}, {}};
  for (const LocalTrack& track : tracks) late.contributions.push_back({&track, track.newest().state});
  const FusedState fused = method.fuse({&late, 1}).front();
  EXPECT_GT(fused.state(1), -15.0);
  EXPECT_LT(fused.state(1), 5.0);
  EXPECT_GT(fused.covariance(0, 0), 0.0);
  EXPECT_LT(fused.covariance(0, 0), nodes[0].covariance(0, 0));  // Better than the better of the two.
}

TEST(MaximumLikelihoodFusion, RefusesABadParameter) {
  EXPECT_THROW(MaximumLikelihoodFusion({-1.0, 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
