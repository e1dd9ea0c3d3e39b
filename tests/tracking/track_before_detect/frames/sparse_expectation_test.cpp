#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/frames/expectations.hpp"
#include "tracking/track_before_detect/axis_integrals.hpp"

namespace lookout::tracking {
namespace {

TEST(SparseExpectation, WithoutDisplayedCellsARefillHasNothingToGive) {
  const IntensityFrame frame{20, 10, std::vector<double>(200, 1.0)};
  const CellModel model{{10.0, 5.0}, {4.0, 4.0}, 0.5};
  const auto e_step = make_cell_expectation(CellForm::sparse, Truncation::impute);
  e_step->prepare(frame, 2.0);
  const Expectation& result = e_step->evaluate(0.5, {&model, 1});
  EXPECT_EQ(result.total_probability, 0.0);
  EXPECT_EQ(result.targets[0].responsibility, 0.0);
}

TEST(SparseExpectation, RefilledCellsAreTheAxisSumsTimesOneConstant) {
  // One displayed cell, far from the model: there z / P_l = 7 / P_l, elsewhere c = 7 / P_t with P_t = P_l. So
  // z / P_l - c = 0 and n_k is c times the model's mass in the frame.
  IntensityFrame frame{20, 10, std::vector<double>(200, 0.0)};
  frame.values[frame.index(19, 9)] = 7.0;
  const CellModel model{{4.0, 5.0}, {1.0, 1.0}, 0.5};
  const auto e_step = make_cell_expectation(CellForm::sparse, Truncation::impute);
  e_step->prepare(frame, 1.0);
  const Expectation& result = e_step->evaluate(0.5, {&model, 1});
  const double mass =
      integrate_cell(4.0, 1.0, 0.0, 20.0).probability * integrate_cell(5.0, 1.0, 0.0, 10.0).probability;
  const double far =
      integrate_cell(4.0, 1.0, 19.0, 20.0).probability * integrate_cell(5.0, 1.0, 9.0, 10.0).probability;
  EXPECT_NEAR(result.targets[0].responsibility, 7.0 / (0.5 / 200.0 + 0.5 * far) * mass, 1e-6);
}

}  // namespace
}  // namespace lookout::tracking
