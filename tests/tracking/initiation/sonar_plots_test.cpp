#include "tracking/initiation/sonar_plots.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace lookout::tracking {
namespace {

core::PosedScan scan_of(const core::SonarParams& sonar, std::vector<core::SonarReturn> returns) {
  core::PosedScan posed;
  posed.T_earth_sonar = {1000.0, 2000.0, 0.0};
  posed.scan.first_bearing = sonar.first_bearing;
  posed.scan.bearing_step = sonar.bearing_step;
  posed.scan.num_beams = sonar.num_beams;
  posed.scan.max_range = sonar.max_range;
  posed.scan.returns = std::move(returns);
  return posed;
}

TEST(SonarPlots, PositionsAreThoseAroundTheFirstPlaceOfTheSonar) {
  const core::SonarParams sonar;
  SonarPlots sonar_plots;
  core::PosedScan scan = scan_of(sonar, {{0.0, 50.0, 1.0}});
  EXPECT_LT((sonar_plots.of(scan, sonar)[0].position - Eigen::Vector2d(50.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(sonar_plots.p_earth_origin(), Eigen::Vector2d(1000.0, 2000.0));
  scan.T_earth_sonar.north += 10.0;
  EXPECT_LT((sonar_plots.of(scan, sonar)[0].position - Eigen::Vector2d(60.0, 0.0)).norm(), 1e-9);
}

TEST(SonarPlots, ClutterEvenOverRangeAndBearingThinsWithRange) {
  core::SonarParams sonar;
  sonar.range_sigma = 3.0;
  SonarPlots sonar_plots;
  const auto plots =
      sonar_plots.of(scan_of(sonar, {{0.0, 100.0, 1.0}, {0.1, 50.0, 1.0}, {0.2, 4.0, 1.0}}), sonar);
  // Three returns over 90 beams of 1 degree and 150 m, at 94, 44 and (two sigmas nearer than 4 m) 0.15 m.
  const double per_range = 3.0 / (0.5 * std::numbers::pi * 150.0);
  EXPECT_NEAR(plots[0].clutter_density, per_range / 94.0, 1e-9);
  EXPECT_NEAR(plots[1].clutter_density, per_range / 44.0, 1e-9);
  EXPECT_NEAR(plots[2].clutter_density, per_range / 0.15, 1e-6);
}

TEST(SonarPlots, AnEmptyScanHasNone) {
  SonarPlots sonar_plots;
  EXPECT_TRUE(sonar_plots.of(scan_of({}, {}), {}).empty());
}

}  // namespace
}  // namespace lookout::tracking
