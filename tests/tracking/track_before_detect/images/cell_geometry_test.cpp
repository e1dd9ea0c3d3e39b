#include "tracking/track_before_detect/images/cell_geometry.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

core::PosedImage fan() {
  core::PosedImage posed;
  posed.image.first_bearing = core::radians(-44.5);
  posed.image.bearing_step = core::radians(1.0);
  posed.image.first_range = 0.25;
  posed.image.range_step = 0.5;
  posed.image.num_beams = 90;
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

TEST(CellGeometry, BehindTheSonarIsOutside) {
  const core::PosedImage posed = fan();
  const Eigen::Vector2d behind = core::transform(posed.T_earth_sonar, {-30.0, 0.0});
  EXPECT_FALSE(SonarCellGeometry(posed).observe(behind).inside);
  EXPECT_FALSE(PixelGeometry(10, 10).observe({10.0, 5.0}).inside);
  EXPECT_TRUE(PixelGeometry(10, 10).observe({9.9, 5.0}).inside);
}

}  // namespace
}  // namespace lookout::tracking
