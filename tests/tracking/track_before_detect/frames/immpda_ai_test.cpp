#include "tracking/track_before_detect/frames/immpda_ai.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tracking {
namespace {

IntensityFrame with_square(int column, int row) {
  IntensityFrame frame{100, 80, std::vector<double>(8000, 1.0)};
  for (int y = row; y < row + 10; ++y)
    for (int x = column; x < column + 10; ++x) frame.values[frame.index(x, y)] = 8.0;
  return frame;
}

TEST(ImmpdaAi, PointsAreBlockCentresWithTheMeanAsAmplitude) {
  std::vector<AmplitudePoint> points;
  extract_points(with_square(20, 30), 5, 4.0, points);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0].position, Eigen::Vector2d(22.5, 32.5));
  EXPECT_DOUBLE_EQ(points[0].amplitude, 8.0);
}

TEST(ImmpdaAi, AmplitudeRatioIsThatOfTruncatedRayleighDensities) {
  const double a = 5.0, t = 2.0, d = 9.0;
  const auto density = [t](double x, double power) {
    return x / power * std::exp(-x * x / (2 * power)) / std::exp(-t * t / (2 * power));
  };
  EXPECT_NEAR(amplitude_ratio(a, t, d), density(a, 1 + d) / density(a, 1.0), 1e-9 * amplitude_ratio(a, t, d));
}

TEST(ImmpdaAi, FollowsAMovingSquare) {
  const auto tracker = make_immpda_ai({});
  tracker->add(1, {20.0, 35.0, 2.0, 0.0}, Eigen::Vector4d(4, 4, 0.04, 0.04).asDiagonal());
  FrameTrack track;
  const double one = 1.0;
  for (int t = 1; t <= 20; ++t) {
    const IntensityFrame frame = with_square(15 + 2 * t, 30);
    track = tracker->process({&frame, 1}, {&one, 1}).back().front();
  }
  EXPECT_NEAR(track.state[0], 60.0, 2.0);  // within half a block
  EXPECT_NEAR(track.state[1], 35.0, 2.0);
  EXPECT_NEAR(track.state[2], 2.0, 0.4);
}

TEST(ImmpdaAi, CoastsWithoutPoints) {
  const auto tracker = make_immpda_ai({});
  tracker->add(1, {20.0, 35.0, 2.0, 0.0}, Eigen::Vector4d(4, 4, 0.04, 0.04).asDiagonal());
  const IntensityFrame frame{100, 80, std::vector<double>(8000, 1.0)};
  const double one = 1.0;
  const FrameTrack track = tracker->process({&frame, 1}, {&one, 1}).back().front();
  EXPECT_NEAR(track.state[0], 22.0, 1e-9);
}

TEST(ImmpdaAi, RefusesParametersOutOfRange) {
  ImmpdaAiParams params;
  params.detection_probability = 1.0;
  EXPECT_THROW(make_immpda_ai(params), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
