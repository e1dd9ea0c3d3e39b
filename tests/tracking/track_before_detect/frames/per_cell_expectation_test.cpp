#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/frames/expectations.hpp"
#include "tracking/track_before_detect/axis_integrals.hpp"

namespace lookout::tracking {
namespace {

TEST(PerCellExpectation, OneBrightCellByHand) {
  // A frame of 2 x 1 cells, the left one bright with 6: P_l = .5 / 2 + .5 P_kl, and the sums are 6 / P_l
  // times the cell's own integrals. [Pakfiliz2018] Eq. (7), (12).
  const IntensityFrame frame{2, 1, {6.0, 0.0}};
  const CellModel model{{0.8, 0.5}, {1.0, 2.0}, 0.5};
  const auto e_step = make_cell_expectation(CellForm::per_cell, Truncation::zero);
  e_step->prepare(frame, 1.0);
  const Expectation& result = e_step->evaluate(0.5, {&model, 1});
  const CellIntegrals x = integrate_cell(0.8, 1.0, 0.0, 1.0), y = integrate_cell(0.5, 2.0, 0.0, 1.0);
  const double share = 6.0 / (0.25 + 0.5 * x.probability * y.probability);
  EXPECT_EQ(result.total_intensity, 6.0);
  EXPECT_NEAR(result.targets[0].responsibility, share * x.probability * y.probability, 1e-12);
  EXPECT_NEAR(result.targets[0].first.x(), share * x.first * y.probability, 1e-12);
  EXPECT_NEAR(result.targets[0].second.y(), share * x.probability * y.second, 1e-12);
}

TEST(PerCellExpectation, RefillsTheDarkCellsFromTheModel) {
  // Eq. (9): the dark cell counts as ||Z|| P_l / P_t, so that its weight over P_l is 6 / P_t, P_t = P_1.
  const IntensityFrame frame{2, 1, {6.0, 0.0}};
  const CellModel model{{0.8, 0.5}, {1.0, 2.0}, 0.5};
  const auto e_step = make_cell_expectation(CellForm::per_cell, Truncation::impute);
  e_step->prepare(frame, 1.0);
  const Expectation& result = e_step->evaluate(0.5, {&model, 1});
  const double left = integrate_cell(0.8, 1.0, 0.0, 1.0).probability;
  const double right = integrate_cell(0.8, 1.0, 1.0, 2.0).probability;
  const double y = integrate_cell(0.5, 2.0, 0.0, 1.0).probability;
  const double displayed = 0.25 + 0.5 * left * y;
  EXPECT_NEAR(result.total_probability, displayed, 1e-12);
  EXPECT_NEAR(result.targets[0].responsibility, 6.0 / displayed * (left + right) * y, 1e-12);
}

}  // namespace
}  // namespace lookout::tracking
