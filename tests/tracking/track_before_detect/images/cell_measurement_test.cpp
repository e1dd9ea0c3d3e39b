#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/blobs.hpp"
#include "tracking/track_before_detect/images/cell_tracker.hpp"

namespace lookout::tracking {
namespace {

TEST(CellMeasurement, TwoTargetsInOneGateShareTheCells) {
  core::Random random(1002);
  std::vector<CellTrack> tracks(2);
  const Eigen::Vector2d centres[] = {{40.0, 40.0}, {44.5, 40.0}};
  for (std::size_t k = 0; k < 2; ++k) {
    tracks[k].state.head<2>() = centres[k] + Eigen::Vector2d(0.5, -0.3);
    tracks[k].covariance = Eigen::Vector4d(1.0, 1.0, 0.1, 0.1).asDiagonal();
    tracks[k].intensity = 5.0;
  }
  CellMeasurement measurement({});
  measurement.update(blobs({centres[0], centres[1]}, 20.0, random), PixelGeometry(120, 80), tracks);
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
  CellMeasurement measurement({}), other({});
  measurement.update(blobs({}, 0.0, random), PixelGeometry(120, 80), empty);
  other.update(blobs({{60.0, 40.0}}, 20.0, random), PixelGeometry(120, 80), full);
  EXPECT_LT(full[0].covariance(0, 0), 0.5);
  EXPECT_GT(empty[0].covariance(0, 0), 2.0 * full[0].covariance(0, 0));
  EXPECT_LT(empty[0].intensity, full[0].intensity);
}

}  // namespace
}  // namespace lookout::tracking
