#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/tracking/track_before_detect/blobs.hpp"
#include "tracking/track_before_detect/images/cell_measurement.hpp"

namespace lookout::tracking {
namespace {

/// Updates the tracks by one frame in its own cells, each from its predicted place.
void measure(const IntensityFrame& frame, std::vector<CellTrack>& tracks,
             const CellMeasurementParams& params = {}) {
  ScaleSpaceParams one_scale;
  one_scale.largest = {1e-3, 1e-3};
  ScaleSpace scales(one_scale, params.threshold);
  scales.apply(frame, {1.0, 1.0}, {});
  std::vector<Eigen::Vector2d> starts;
  for (const CellTrack& track : tracks) starts.push_back(track.state.head<2>());
  CellMeasurement(params).update(scales, PixelGeometry(120, 80), tracks, starts);
}

TEST(CellMeasurement, TwoTargetsInOneGateShareTheCells) {
  core::Random random(1002);
  std::vector<CellTrack> tracks(2);
  const Eigen::Vector2d centres[] = {{40.0, 40.0}, {44.5, 40.0}};
  for (std::size_t k = 0; k < 2; ++k) {
    tracks[k].state.head<2>() = centres[k] + Eigen::Vector2d(0.5, -0.3);
    tracks[k].covariance = Eigen::Vector4d(1.0, 1.0, 0.1, 0.1).asDiagonal();
    tracks[k].intensity = 5.0;
  }
  measure(blobs({centres[0], centres[1]}, 20.0, random), tracks);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT((tracks[k].state.head<2>() - centres[k]).norm(), 0.35);
}

TEST(CellMeasurement, NoiseAloneHardlyMovesATrackAndKeepsItsCovariance) {
  // A track where there is nothing, of next to no intensity: its covariance must not shrink as by a
  // detection.
  core::Random random(1003);
  std::vector<CellTrack> empty(1), full(1);
  for (auto* tracks : {&empty, &full}) {
    (*tracks)[0].state.head<2>() = Eigen::Vector2d(60.0, 40.0);
    (*tracks)[0].covariance = Eigen::Vector4d(1.0, 1.0, 0.1, 0.1).asDiagonal();
    (*tracks)[0].intensity = 5.0;
  }
  measure(blobs({}, 0.0, random), empty);
  measure(blobs({{60.0, 40.0}}, 20.0, random), full);
  EXPECT_LT(full[0].covariance(0, 0), 0.5);
  EXPECT_GT(empty[0].covariance(0, 0), 2.0 * full[0].covariance(0, 0));
  EXPECT_LT(empty[0].intensity, full[0].intensity);
}

// The squared error over the stated variance is 1 on average where the variance is right. 200 draws of two
// axes scatter by .07; a start that is off by a cell and a peak of the noise now and then leave room above.
TEST(CellMeasurement, TheStatedVarianceIsThatOfTheErrors) {
  core::Random random(1005);
  double sum = 0.0;
  constexpr int kDraws = 200;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector2d centre(60.0 + random.uniform(0.0, 1.0), 40.0 + random.uniform(0.0, 1.0));
    std::vector<CellTrack> tracks(1);
    tracks[0].state.head<2>() = centre + Eigen::Vector2d(random.gaussian(0.5), random.gaussian(0.5));
    tracks[0].covariance = Eigen::Vector4d(100.0, 100.0, 1.0, 1.0).asDiagonal();
    tracks[0].intensity = 20.0;
    measure(blobs({centre}, 6.0, random), tracks);
    const Eigen::Vector2d error = tracks[0].state.head<2>() - centre;
    sum += error.dot(tracks[0].covariance.topLeftCorner<2, 2>().inverse() * error) / 2.0;
  }
  EXPECT_GT(sum / kDraws, 0.6);
  EXPECT_LT(sum / kDraws, 2.0);
}

TEST(CellMeasurement, WhatLiesOutsideTheGateIsNotTheTarget) {
  core::Random random(1006);
  std::vector<CellTrack> tracks(1);
  tracks[0].state.head<2>() = Eigen::Vector2d(56.0, 40.0);
  tracks[0].covariance = Eigen::Vector4d(1e-3, 1e-3, 0.1, 0.1).asDiagonal();
  tracks[0].intensity = 20.0;
  measure(blobs({{58.0, 40.0}}, 20.0, random), tracks);
  EXPECT_FALSE(tracks[0].measured);
  EXPECT_EQ(tracks[0].state[0], 56.0);
}

}  // namespace
}  // namespace lookout::tracking
