#include "tracking/track_before_detect/images/cell_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

constexpr double kFirst = std::numeric_limits<double>::infinity();  // [s] since the frame before the first

constexpr double kThreshold = 1.9;
const Eigen::Vector2d kTarget(60.0, 40.0);

/// The scales of one frame with a target at kTarget.
ScaleSpace seen(double amplitude) {
  core::Random random(1000);
  ScaleSpaceParams params;
  params.same_on_both_axes = true;
  ScaleSpace scales(params, kThreshold);
  scales.apply(blobs({kTarget}, amplitude, random), {1.0, 1.0}, {});
  return scales;
}

CellTrack track_at(const Eigen::Vector2d& position) {
  CellTrack track;
  track.state.head<2>() = position;
  track.covariance = Eigen::Vector4d(0.25, 0.25, 0.04, 0.04).asDiagonal();
  track.existence = 0.5;
  track.measured = true;
  return track;
}

// a p^(a - 1) in closed form; below the least probability it says no more.
TEST(CellEvidence, TheRatioIsTheDensityOfTheRank) {
  const CellEvidence evidence({});
  EXPECT_NEAR(evidence.log_ratio(0.0), std::log(0.15), 1e-12);
  EXPECT_NEAR(evidence.log_ratio(std::log(0.01)), std::log(0.15 * std::pow(0.01, -0.85)), 1e-12);
  EXPECT_EQ(evidence.log_ratio(-100.0), evidence.log_ratio(std::log(1e-6)));
}

TEST(CellEvidence, AFrameSpeaksForATrackAtATargetAndAgainstOneElsewhere) {
  const CellEvidence evidence({});
  const ScaleSpace scales = seen(8.0);
  const PixelGeometry geometry(120, 80);
  const Eigen::Vector2d elsewhere(20.0, 20.0), outside(-5.0, 20.0);
  EXPECT_GT(evidence.likelihood_ratio(scales, geometry, track_at(kTarget), kTarget), 10.0);
  EXPECT_LT(evidence.likelihood_ratio(scales, geometry, track_at(elsewhere), elsewhere), 1.0);
  EXPECT_EQ(evidence.likelihood_ratio(scales, geometry, track_at(outside), outside), 1.0);
}

// Odds of 1 times a ratio of 3; a track that took nothing from the frame has the least of ratios, a.
TEST(CellEvidence, ExistenceFollowsBayesRule) {
  const CellEvidence evidence({});
  CellTrack track = track_at(kTarget);
  evidence.judge_existence(track, 3.0, 7.0);
  EXPECT_NEAR(track.existence, 0.75, 1e-12);
  EXPECT_EQ(track.last_detection_time, 7.0);
  CellTrack missed = track_at(kTarget);
  missed.measured = false;
  evidence.judge_existence(missed, 3.0, 7.0);
  EXPECT_NEAR(missed.existence, 0.15 / 1.15, 1e-12);
  EXPECT_EQ(missed.last_detection_time, 0.0);
}

TEST(CellEvidence, ALessProbableBlockMakesASurerStart) {
  const CellEvidence evidence({});
  const ScaleSpace scales = seen(8.0);
  const double likely = evidence.first_existence(scales, {0, kTarget, 0.0, std::log(1e-2)}, kFirst);
  const double unlikely = evidence.first_existence(scales, {0, kTarget, 0.0, std::log(1e-5)}, kFirst);
  EXPECT_GT(unlikely, 10.0 * likely);
  EXPECT_LT(unlikely, 1.0);
}

// Six targets a second, but three in a frame at most: as many at the first frame as after 2 s; .3 after .05
// s.
TEST(CellEvidence, TargetsAppearInTimeNotInFrames) {
  const CellEvidence evidence({});
  const ScaleSpace scales = seen(8.0);
  const auto odds = [&](double step) {
    const double existence = evidence.first_existence(scales, {0, kTarget, 0.0, std::log(1e-2)}, step);
    return existence / (1.0 - existence);
  };
  EXPECT_NEAR(odds(2.0), odds(kFirst), 1e-12);
  EXPECT_NEAR(odds(0.05), 0.1 * odds(kFirst), 1e-12);
}

/// Noise with a blob of a standard deviation [px] at kTarget.
IntensityFrame wide_blob(double sigma, double amplitude) {
  core::Random random(1001);
  IntensityFrame frame = blobs({}, 0.0, random);
  for (int row = 0; row < frame.rows; ++row)
    for (int column = 0; column < frame.columns; ++column) {
      const double squared = (Eigen::Vector2d(column + 0.5, row + 0.5) - kTarget).squaredNorm();
      frame.values[frame.index(column, row)] += amplitude * std::exp(-0.5 * squared / (sigma * sigma));
    }
  return frame;
}

// Four times the finest scale's signature: in its pooled cells the block is the less probable.
TEST(CellEvidence, ATrackMovesToTheScaleOfItsTarget) {
  ScaleSpaceParams params;
  params.same_on_both_axes = true;
  params.largest = {6.0, 6.0};
  params.fewest_cells = 10;
  ScaleSpace scales(params, kThreshold);
  scales.apply(wide_blob(4.0, 0.7), {1.0, 1.0}, {});
  ASSERT_GE(scales.scales().size(), 2u);
  CellTrack track = track_at(kTarget);
  judge_scale(scales, PixelGeometry(120, 80).observe(kTarget), track);
  EXPECT_GE(track.scale, 1);
}

}  // namespace
}  // namespace lookout::tracking
