#include "tracking/track_before_detect/images/cell_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/beam_bearings.hpp"

namespace lookout::tracking {
namespace {

core::PosedImage fan() {
  core::PosedImage posed;
  posed.image.bearings = core::even_bearings(core::radians(-44.5), core::radians(1.0), 90);
  posed.image.first_range = 0.25;
  posed.image.range_step = 0.5;
  posed.image.num_bins = 300;
  posed.T_earth_sonar = {10.0, -20.0, 0.7};
  return posed;
}

TEST(CellGeometry, CellsAndPositionsAreInverse) {
  const SonarCellGeometry geometry(fan());
  for (const Eigen::Vector2d& cell : {Eigen::Vector2d(120.5, 30.5), Eigen::Vector2d(12.0, 80.25)}) {
    const CellView view = geometry.observe(geometry.position_of(cell));
    EXPECT_LT((view.cell - cell).norm(), 1e-9);
    EXPECT_TRUE(view.inside);
  }
}

TEST(CellGeometry, TheCentreOfCellZeroLiesAtOneHalf) {
  const core::PosedImage posed = fan();
  const Eigen::Vector2d p_earth =
      core::transform(posed.T_earth_sonar, core::from_polar(0.25, core::radians(-44.5)));
  EXPECT_LT((SonarCellGeometry(posed).observe(p_earth).cell - Eigen::Vector2d(0.5, 0.5)).norm(), 1e-9);
}

TEST(CellGeometry, JacobianIsTheDifferenceQuotient) {
  const SonarCellGeometry geometry(fan());
  const Eigen::Vector2d p(70.0, 30.0);
  const CellView view = geometry.observe(p);
  constexpr double kStep = 1e-5;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d d = kStep * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d slope = (geometry.observe(p + d).cell - geometry.observe(p - d).cell) / (2 * kStep);
    EXPECT_LT((slope - view.jacobian.col(axis)).norm(), 1e-6);
  }
}

TEST(CellGeometry, OfUnevenBeamsEachCentreLiesInItsOwnRow) {
  core::PosedImage posed = fan();
  posed.image.bearings = {-0.5, -0.2, 0.0, 0.05};
  const SonarCellGeometry geometry(posed);
  for (std::size_t beam = 0; beam < posed.image.bearings.size(); ++beam) {
    const Eigen::Vector2d p_sonar = core::from_polar(50.0, posed.image.bearings[beam]);
    const CellView view = geometry.observe(core::transform(posed.T_earth_sonar, p_sonar));
    EXPECT_NEAR(view.cell.y(), static_cast<double>(beam) + 0.5, 1e-9);
  }
  const Eigen::Vector2d between = geometry.position_of({100.0, 1.0});  // Half way from beam 0 to 1.
  const Eigen::Vector2d p_sonar = core::inverse_transform(posed.T_earth_sonar, between);
  EXPECT_NEAR(std::atan2(p_sonar.y(), p_sonar.x()), -0.35, 1e-12);
}

TEST(CellGeometry, BehindTheSonarIsOutside) {
  const core::PosedImage posed = fan();
  const Eigen::Vector2d behind = core::transform(posed.T_earth_sonar, {-30.0, 0.0});
  EXPECT_FALSE(SonarCellGeometry(posed).observe(behind).inside);
  EXPECT_FALSE(PixelGeometry(10, 10).observe({10.0, 5.0}).inside);
  EXPECT_TRUE(PixelGeometry(10, 10).observe({9.9, 5.0}).inside);
}

}  // namespace
}  // namespace lookout::tracking
