#include "csht/likelihood/clutter/clutter_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kRate = 9.0;  // A tenth of 90 beams.
constexpr int kScans = 80;
constexpr double kRock = 100.0;  // North [m].

// Cell of the 60 x 50 that a beam and a range of the sonar of [Yan2018] fall into.
std::size_t cell(double beam, double range) {
  return static_cast<std::size_t>(60.0 * (beam + 0.5) / 90.0) * 50 +
         static_cast<std::size_t>(50.0 * range / 150.0);
}

core::SonarReturn in_beam(int beam, double range) {
  return {core::radians(-44.5 + beam), range, 1};
}

/// A sonar that goes north at `speed` [m/s] hears uniform clutter, in beam 20 at 60 m something that goes
/// with it, and dead ahead a rock.
core::ClutterGrid learnt(double speed) {
  ScanHistory history({}, {}, 2);
  ClutterMap map({}, core::SonarParams{});
  core::Random random(5);
  for (int k = 0; k < kScans; ++k) {
    const double north = 0.5 * k * speed;
    std::vector<core::SonarReturn> returns{in_beam(20, 60.0), in_beam(45, kRock - north)};
    for (int beam = 0; beam < 90; ++beam)
      if (beam != 20 && beam != 45 && random.bernoulli(0.1))
        returns.push_back(in_beam(beam, random.uniform(0.1, 150.0)));
    history.push(posed_scan(returns, 500'000L * k, {north, 0.0, 0.0}));
    map.learn(history.newest(), std::vector<double>(history.newest().detections.size()), kRate);
    map.add(history.newest());
  }
  return clutter_grid(map, history.newest(), kRate);
}

TEST(ClutterGrid, ShowsWhatGoesAlongAndWhatStandsWhereTheyAreNow) {
  const double speed = 0.8, way = 0.5 * (kScans - 1) * speed;
  const core::ClutterGrid grid = learnt(speed);
  EXPECT_EQ(grid.utime, 500'000 * (kScans - 1));
  EXPECT_NEAR(grid.T_earth_sonar.north, way, 1e-9);
  EXPECT_GE(grid.density[cell(20, 60.0)], 10);  // Ten times the background and more.
  EXPECT_GE(grid.density[cell(45, kRock - way)], 10);
  EXPECT_LE(grid.density[cell(45, kRock)], 3);  // Where the rock was seen at first.
}

TEST(ClutterGrid, LeavesMostOfAUniformSeaAtTheBackground) {
  const core::ClutterGrid grid = learnt(0.0);
  ASSERT_EQ(grid.density.size(), 3000u);
  const auto dense = std::count_if(grid.density.begin(), grid.density.end(), [](int db) { return db > 3; });
  EXPECT_GT(dense, 0);
  EXPECT_LT(dense, 150);  // One cell in twenty.
}

TEST(ClutterGrid, CoversTheFan) {
  const core::ClutterGrid grid = learnt(0.0);
  EXPECT_NEAR(grid.first_bearing, core::radians(-45.0), 1e-9);
  EXPECT_NEAR(grid.first_bearing + grid.num_bearings * grid.bearing_step, core::radians(45.0), 1e-9);
  EXPECT_NEAR(grid.num_ranges * grid.range_step, 150.0, 1e-9);
}

TEST(ClutterGrid, OfAMapWithoutScansIsEmpty) {
  ScanHistory history({}, {}, 2);
  history.push(posed_scan({in_beam(45, 70.0)}));
  const core::ClutterGrid grid = clutter_grid(ClutterMap({}, core::SonarParams{}), history.newest(), kRate);
  EXPECT_EQ(std::count(grid.density.begin(), grid.density.end(), 0), 3000);
}

}  // namespace
}  // namespace lookout::csht
