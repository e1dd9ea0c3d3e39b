#include "fusion/methods/central_kalman_fusion.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/filter_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::group;
using testing::message;
using testing::Node;

TEST(CentralKalmanFusion, EqualsAFilterOfAllMeasurements) {
  const KalmanModel model{0.05, 3.0};
  Node one{4.0}, two{9.0}, central{4.0};
  CentralKalmanFusion fusion(model);
  std::vector<LocalTrack> tracks;
  for (int k = 0; k < 12; ++k) {
    const Eigen::Vector2d z1(k + 0.3 * (k % 3), 1.0 - 0.2 * (k % 4)), z2(k - 0.5 * (k % 2), 0.4 * (k % 5));
    if (k == 0) {
      one.start(z1, model.velocity_sigma);
      two.start(z2, model.velocity_sigma);
      central.start(z1, model.velocity_sigma);
      tracks = {LocalTrack(message(one, 1, k)), LocalTrack(message(two, 2, k))};
    } else {
      for (Node* node : {&one, &two, &central}) node->predict(model);
      one.correct(z1, one.r);
      two.correct(z2, two.r);
      central.correct(z1, one.r);
      tracks[0].append(message(one, 1, k));
      tracks[1].append(message(two, 2, k));
    }
    central.correct(z2, two.r);
    if (k < 3) continue;  // The tracks are told apart a little later; their start is replayed.
    TrackGroup joint = group({0, 0, 1, 0}, tracks);
    joint.utime = core::microseconds(k);
    const std::vector<TrackGroup> groups{joint};
    const FusedState& fused = fusion.fuse(groups).front();
    EXPECT_NEAR((fused.state - central.state).norm(), 0.0, 1e-6) << "scan " << k;
    EXPECT_NEAR((fused.covariance - central.covariance).norm(), 0.0, 1e-6) << "scan " << k;
  }
}

TEST(CentralKalmanFusion, RefusesABadParameter) {
  EXPECT_THROW(CentralKalmanFusion({0.1, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
