#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/frames/expectations.hpp"
#include "tracking/track_before_detect/axis_integrals.hpp"

namespace lookout::tracking {
namespace {

TEST(SeparableExpectation, AFlatFrameGivesTheModelsOwnMoments) {
  // Every cell holds 1 and the model has all the weight: z / P_l = 1 / P_l, so that n_k counts the cells.
  const IntensityFrame frame{20, 10, std::vector<double>(200, 1.0)};
  const CellModel model{{10.0, 5.0}, {16.0, 9.0}, 1.0};
  const auto e_step = make_cell_expectation(CellForm::separable, Truncation::zero);
  e_step->prepare(frame, 0.5);
  const Expectation& result = e_step->evaluate(0.0, {&model, 1});
  EXPECT_NEAR(result.targets[0].responsibility, 200.0, 1e-9);
  EXPECT_NEAR(result.targets[0].first.norm(), 0.0, 1e-9);  // Symmetric about the mean.
}

TEST(SeparableExpectation, AFarModelIsZeroAndNotANumberTooSmall) {
  // 60 standard deviations away along both axes: the products are below the smallest double.
  const IntensityFrame frame{20, 10, std::vector<double>(200, 1.0)};
  const CellModel model{{-60.0, -60.0}, {1.0, 1.0}, 0.5};
  const auto e_step = make_cell_expectation(CellForm::separable, Truncation::zero);
  e_step->prepare(frame, 0.5);
  EXPECT_EQ(e_step->evaluate(0.5, {&model, 1}).targets[0].responsibility, 0.0);
}

}  // namespace
}  // namespace lookout::tracking
