#include "fusion/covariance_fusion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fusion/central_kalman_fusion.hpp"
#include "fusion/maximum_likelihood_fusion.hpp"
#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::estimate;
using testing::group;

/// A node's two estimates with the covariance diag(a, b, 1, 1).
LocalTrack with_covariance(std::int32_t node, const Eigen::Vector4d& state, double a, double b) {
  LocalTrack track = testing::tracklet(node, state);
  LocalEstimate older = track.back(1), newer = track.newest();
  older.covariance = newer.covariance = Eigen::Vector4d(a, b, 1, 1).asDiagonal().toDenseMatrix();
  LocalTrack result(older);
  result.append(newer);
  return result;
}

FusedState fuse(FusionMethod& method, const std::vector<LocalTrack>& tracks) {
  const std::vector<TrackGroup> groups{group({0, 0, 1, 0}, tracks)};
  return method.fuse(groups).front();
}

TEST(CovarianceFusion, SumOfInformationByHand) {
  CovarianceFusion method(CovarianceWeights::sum, 0.0);
  const auto fused =
      fuse(method, {with_covariance(1, {0, 0, 1, 0}, 1.0, 4.0), with_covariance(2, {4, 4, 1, 0}, 4.0, 1.0)});
  // 4 / (1 + 4) and 4 * 4 / 5 from the inverse variances 1 and 1/4.
  EXPECT_NEAR(fused.state.x(), 0.8, 1e-12);
  EXPECT_NEAR(fused.state.y(), 3.2, 1e-12);
  EXPECT_NEAR(fused.covariance(0, 0), 0.8, 1e-12);
}

TEST(CovarianceFusion, IntersectionOfEqualSensorsClaimsNoGain) {
  CovarianceFusion method(CovarianceWeights::intersection, 0.0);
  const auto fused =
      fuse(method, {with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0), with_covariance(2, {4, 4, 1, 0}, 2.0, 2.0)});
  EXPECT_NEAR(fused.state.x(), 2.0, 1e-12);
  EXPECT_NEAR(fused.covariance(0, 0), 2.0, 1e-12);  // P^-1 = 0.5 P^-1 + 0.5 P^-1.
}

TEST(CovarianceFusion, AnOldEstimateIsLessCertain) {
  const LocalTrack track = with_covariance(1, {0, 0, 1, 0}, 2.0, 2.0);
  // P + t^2 (velocity variance 1) + q t^3 / 3 after t = 2 s with q = 3.
  EXPECT_NEAR(covariance_at(track, core::microseconds(3.0), 3.0)(0, 0), 2.0 + 4.0 + 8.0, 1e-12);
}

/// One node's linear Kalman filter of a target, with position noise of variance `r` in both axes.
struct Node {
  double r;
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();

  void start(const Eigen::Vector2d& z, double velocity_sigma) {
    state << z, 0.0, 0.0;
    covariance.diagonal() << r, r, velocity_sigma * velocity_sigma, velocity_sigma * velocity_sigma;
  }
  void predict(const KalmanModel& model) {
    state = moved(state, 1.0);
    covariance =
        transition(1.0) * covariance * transition(1.0).transpose() + process_noise(1.0, model.process_noise);
  }
  void correct(const Eigen::Vector2d& z, double variance) {
    const Eigen::Matrix2d innovation =
        covariance.topLeftCorner<2, 2>() + variance * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
    state += gain * (z - state.head<2>());
    covariance -= (gain * covariance.topRows<2>()).eval();
    covariance = (0.5 * (covariance + covariance.transpose())).eval();
  }
};

LocalEstimate message(const Node& node, std::int32_t id, int k) {
  LocalEstimate result = estimate(id, 1, k, node.state);
  result.covariance = node.covariance;
  return result;
}

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

TEST(Bounds, RefuseBadParameters) {
  EXPECT_THROW(MaximumLikelihoodFusion({-1.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(CentralKalmanFusion({0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(CovarianceFusion(CovarianceWeights::sum, -0.1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::fusion
