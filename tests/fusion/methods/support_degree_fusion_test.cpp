#include "fusion/methods/support_degree_fusion.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::group;
using testing::tracklet;

constexpr double kSpeed = 10.0;

/// Fused position of tracklets beside a global track that goes north through the origin.
Eigen::Vector2d fuse(FusionMethod& method, const std::vector<LocalTrack>& tracks) {
  const std::vector<TrackGroup> groups{group({0, 0, kSpeed, 0}, tracks)};
  return method.fuse(groups).front().state.head<2>();
}

SupportDegreeFusion sdf(SupportReading reading) {
  SupportDegreeParams params;
  params.reading = reading;
  return SupportDegreeFusion(params);
}

TEST(SupportDegreeFusion, ColumnReadingGivesTheFarthestNothing) {
  auto method = sdf(SupportReading::col);
  // Lines 100 m and 200 m off, parallel: r = 1 - 100/200 and 0; docs/fusion.md, flaw 1.
  const auto fused = fuse(method, {tracklet(1, {0, 100, kSpeed, 0}), tracklet(2, {0, 200, kSpeed, 0})});
  EXPECT_NEAR(fused.y(), 100.0, 1e-9);
}

TEST(SupportDegreeFusion, EqualWeightsWhereThePrintedFormIsNoughtByNought) {
  for (const auto reading : {SupportReading::any, SupportReading::col, SupportReading::all}) {
    auto method = sdf(reading);
    // One sensor; two at the same distance; and two exactly on the track.
    EXPECT_NEAR(fuse(method, {tracklet(1, {0, 50, kSpeed, 0})}).y(), 50.0, 1e-9);
    EXPECT_NEAR(fuse(method, {tracklet(1, {0, 50, kSpeed, 0}), tracklet(2, {0, -50, kSpeed, 0})}).y(), 0.0,
                1e-9);
    EXPECT_NEAR(fuse(method, {tracklet(1, {4, 0, kSpeed, 0}), tracklet(2, {8, 0, kSpeed, 0})}).x(), 6.0,
                1e-9);
  }
}

TEST(SupportDegreeFusion, DoesNotSeeALateTracklet) {
  auto method = sdf(SupportReading::col);
  // 990 m late on the right line beats two that are 14 m and 18 m off: weights 9/11, 2/11, 0 for parallel
  // lines; docs/fusion.md, flaw 3 has 0.83, 0.17, 0 in its scene.
  const auto fused = fuse(method, {tracklet(1, {-990, 0, kSpeed, 0}), tracklet(2, {0, 14, kSpeed, 0}),
                                   tracklet(3, {0, 18, kSpeed, 0})});
  EXPECT_NEAR(fused.x(), -990.0 * 9.0 / 11.0, 1e-6);
}

TEST(SupportDegreeFusion, FarTargetsTurnTheAllReadingIntoTheMean) {
  auto method = sdf(SupportReading::all);
  const std::vector<LocalTrack> near{tracklet(1, {0, 10, kSpeed, 0}), tracklet(2, {0, 40, kSpeed, 0})};
  const std::vector<LocalTrack> far{tracklet(1, {0, 9e3, kSpeed, 0})};
  const std::vector<TrackGroup> groups{group({0, 0, kSpeed, 0}, near), group({0, 9e3, kSpeed, 0}, far)};
  EXPECT_NEAR(method.fuse(groups).front().state.y(), 25.0, 0.1);  // docs/fusion.md, flaw 6.
}

TEST(SupportDegreeFusion, AStandingTrackletHasTheMeanWeight) {
  auto method = sdf(SupportReading::col);
  // Weights before: 1, 0 and none; the standing one takes their mean: (1, 0, 0.5) / 1.5.
  const auto fused = fuse(
      method, {tracklet(1, {0, 0, kSpeed, 0}), tracklet(2, {0, 90, kSpeed, 0}), tracklet(3, {0, 30, 0, 0})});
  EXPECT_NEAR(fused.y(), 30.0 / 3.0, 1e-9);
}

TEST(SupportDegreeFusion, RefusesAUnitThatIsNotPositive) {
  SupportDegreeParams params;
  params.length_unit = 0.0;
  EXPECT_THROW(SupportDegreeFusion{params}, std::invalid_argument);
}

TEST(SupportDegreeFixed, SeesALateTracklet) {
  SupportDegreeFixed method;
  const auto fused = fuse(method, {tracklet(1, {-990, 0, kSpeed, 0}), tracklet(2, {0, 14, kSpeed, 0}),
                                   tracklet(3, {0, 18, kSpeed, 0})});
  // d^2 = 990^2, 14^2, 18^2 with median 18^2: r = 0.0503, 0.673, 0.55, written out from docs/fusion.md.
  EXPECT_NEAR(fused.x(), -990.0 * 0.0503 / (0.0503 + 0.6731 + 0.55), 0.5);
}

TEST(SupportDegreeFixed, IsFiniteWhereAllAgree) {
  SupportDegreeFixed method;
  const auto fused = fuse(method, {tracklet(1, {0, 0, kSpeed, 0}), tracklet(2, {0, 0, kSpeed, 0})});
  EXPECT_NEAR(fused.norm(), 0.0, 1e-12);
}

TEST(SupportDegreeFixed, DoesNotDependOnWhereTheOriginIs) {
  SupportDegreeFixed method;
  const Eigen::Vector4d far(13700, 9000, 0, 0);
  const auto near_origin = fuse(method, {tracklet(1, {3, 9, kSpeed, 1}), tracklet(2, {0, -4, kSpeed, 0})});
  const std::vector<LocalTrack> moved_tracks{tracklet(1, Eigen::Vector4d(3, 9, kSpeed, 1) + far),
                                             tracklet(2, Eigen::Vector4d(0, -4, kSpeed, 0) + far)};
  const std::vector<TrackGroup> groups{group(Eigen::Vector4d(0, 0, kSpeed, 0) + far, moved_tracks)};
  const Eigen::Vector4d fused = method.fuse(groups).front().state - far;
  EXPECT_NEAR((fused.head<2>() - near_origin).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace lookout::fusion
