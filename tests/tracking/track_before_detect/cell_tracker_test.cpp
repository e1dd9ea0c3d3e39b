#include "tracking/track_before_detect/cell_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

/// Rayleigh noise of median 1 with Gaussian blobs of the given amplitude.
IntensityFrame blobs(const std::vector<Eigen::Vector2d>& centres, double amplitude, core::Random& random) {
  IntensityFrame frame{120, 80, {}};
  const double sigma = 1.0 / std::sqrt(2.0 * std::log(2.0));
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 120; ++column) {
      double signal = 0.0;
      for (const auto& centre : centres) {
        const Eigen::Array2d u =
            (Eigen::Vector2d(column + 0.5, row + 0.5) - centre).array() / Eigen::Array2d(1.1, 0.75);
        signal += amplitude * std::exp(-0.5 * u.square().sum());
      }
      frame.values.push_back(std::hypot(signal + random.gaussian(sigma), random.gaussian(sigma)));
    }
  return frame;
}

TEST(CellTracker, APixelTargetIsConfirmedAndFollowed) {
  core::Random random(1000);
  CellTracker tracker;
  const PixelGeometry geometry(120, 80);
  std::vector<CellTrack> tracks;
  for (int t = 0; t < 30; ++t)
    tracks = tracker.update(blobs({{20.0 + 1.5 * t, 40.0}}, 5.0, random), geometry, t);
  std::erase_if(tracks, [](const CellTrack& track) { return !track.confirmed; });
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(tracks[0].state[0], 20.0 + 1.5 * 29, 0.6);
  EXPECT_NEAR(tracks[0].state[1], 40.0, 0.6);
  EXPECT_NEAR(tracks[0].state[2], 1.5, 0.2);
}

TEST(CellTracker, ATrackWithoutItsTargetEnds) {
  core::Random random(1001);
  CellTracker tracker;
  const PixelGeometry geometry(120, 80);
  std::vector<CellTrack> tracks;
  for (int t = 0; t < 20; ++t) tracks = tracker.update(blobs({{50.0, 40.0}}, 6.0, random), geometry, t);
  EXPECT_TRUE(
      std::any_of(tracks.begin(), tracks.end(), [](const CellTrack& track) { return track.confirmed; }));
  for (int t = 20; t < 45; ++t) tracks = tracker.update(blobs({}, 0.0, random), geometry, t);
  EXPECT_FALSE(
      std::any_of(tracks.begin(), tracks.end(), [](const CellTrack& track) { return track.confirmed; }));
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
  CellMeasurement measurement({});
  measurement.update(blobs({centres[0], centres[1]}, 20.0, random), PixelGeometry(120, 80), tracks);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT((tracks[k].state.head<2>() - centres[k]).norm(), 0.35);
}

TEST(CellTracker, RefusesParametersOutOfRange) {
  CellTrackerParams params;
  params.existence.survival = 0.0;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
  params = {};
  params.measurement.gate_columns = 16;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
