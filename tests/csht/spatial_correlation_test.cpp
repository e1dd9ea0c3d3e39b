#include "csht/spatial_correlation.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

SpatialCorrelation correlation(int max_lines) {
  SpatialCorrelationParams params;
  params.max_lines = max_lines;
  return {params, 3.0, SingleLine({}, HoughSpace({0.4, 1.5, 5.0, 300.0}, {}, 3.0, 3.0))};
}

/// Line samples of one target: north n0 + vn t, east e0 + ve t.
struct Samples {
  std::vector<LineSample> north, east;
  void add(Line n, Line e) {
    for (int k = 0; k < 20; ++k) {
      const double t = 0.5 * k;
      north.push_back({k, t, n.intercept + n.velocity * t, 3.0});
      east.push_back({k, t, e.intercept + e.velocity * t, 3.0});
    }
  }
};

TEST(SpatialCorrelation, FindsTheEastLineOfANorthLine) {
  Samples samples;
  samples.add({1.0, 10.0}, {-2.0, 50.0});
  samples.add({1.0, 60.0}, {0.0, -50.0});  // 50 m away in north: outside the gate of 7.5 m
  auto c = correlation(2);
  const auto lines = c.second_lines({1.0, 10.0}, samples.north, samples.east, 0.0, 0.0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].intercept, 50.0, 0.5);
  EXPECT_NEAR(lines[0].velocity, -2.0, 0.1);
}

// Two targets abreast share their north line: one class, two east lines.
TEST(SpatialCorrelation, SeparatesTwoTargetsOnOneNorthLine) {
  Samples samples;
  samples.add({1.0, 10.0}, {0.0, 40.0});
  samples.add({1.0, 10.0}, {0.0, -40.0});
  auto c = correlation(2);
  const auto lines = c.second_lines({1.0, 10.0}, samples.north, samples.east, 0.0, 0.0);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(std::abs(lines[0].intercept - lines[1].intercept), 80.0, 1.0);
}

// Crossing courses: the gate is taken at each line sample's own time, not at the end. Corrects Eq. (41).
TEST(SpatialCorrelation, GatesAtTheSamplesOwnTime) {
  Samples samples;
  samples.add({3.0, 0.0}, {0.0, 0.0});
  auto c = correlation(1);
  const auto own = c.second_lines({3.0, 0.0}, samples.north, samples.east, 0.0, 0.0);
  ASSERT_EQ(own.size(), 1U);
  EXPECT_NEAR(own[0].velocity, 0.0, 0.1);
}

}  // namespace
}  // namespace lookout::csht
