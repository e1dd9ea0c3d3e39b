#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/tracking/track_before_detect/frame_maker.hpp"
#include "tests/tracking/track_before_detect/frames/expectations.hpp"

namespace lookout::tracking {
namespace {

TEST(GatedExpectation, EqualsSparseWhereTheGateHoldsTheModel) {
  core::Random random(1001);
  const IntensityFrame frame = noisy_frame(120, 90, {26, 16}, random);
  const auto sparse = make_cell_expectation(CellForm::sparse, Truncation::zero);
  const auto gated = make_cell_expectation(CellForm::gated, Truncation::zero, {9.0, 2, 8});
  for (const auto& e_step : {sparse.get(), gated.get()})
    e_step->prepare(frame, displayed_threshold(frame.noise_level, 5.0));
  expect_same(gated->evaluate(0.2, models()), sparse->evaluate(0.2, models()), 1e-9);
}

TEST(GatedExpectation, LearnsTheBackgroundOutsideFromSampledRows) {
  const IntensityFrame frame{200, 160, std::vector<double>(32000, 2.0)};
  const auto gated = make_cell_expectation(CellForm::gated, Truncation::zero);
  gated->prepare(frame, 1.0);
  const std::vector<CellModel> one{{{100.0, 80.0}, {4.0, 4.0}, 0.5}};
  // Every cell holds 2, so that the frame holds 64000; the gate's share of the sampled rows is an estimate.
  EXPECT_NEAR(gated->evaluate(0.5, one).total_intensity, 64000.0, 0.02 * 64000.0);
}

TEST(GatedExpectation, ChecksTheCellsThatItReads) {
  IntensityFrame frame{60, 40, std::vector<double>(2400, 1.0)};
  const std::vector<CellModel> one{{{30.0, 20.0}, {4.0, 4.0}, 0.5}};
  const auto gated = make_cell_expectation(CellForm::gated, Truncation::zero);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  frame.values[frame.index(1, 1)] = nan;  // Outside its gate of 12 cells each way and no sampled row.
  gated->prepare(frame, 3.0);
  EXPECT_NO_THROW(gated->evaluate(0.5, one));
  frame.values[frame.index(33, 22)] = nan;
  EXPECT_THROW(gated->evaluate(0.5, one), std::invalid_argument);
  frame.values[frame.index(5, 16)] = nan;  // Row 16 is half a step of 32 from the top: the first sampled.
  EXPECT_THROW(gated->prepare(frame, 3.0), std::invalid_argument);
}

TEST(GatedExpectation, RefusesTheRefill) {
  EXPECT_THROW(make_cell_expectation(CellForm::gated, Truncation::impute), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
