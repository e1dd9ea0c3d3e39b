#include "tracking/track_before_detect/cell_expectation.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/tracking/track_before_detect/frame_maker.hpp"

namespace lookout::tracking {
namespace {

void expect_same(const Expectation& a, const Expectation& b, double relative) {
  const auto near = [relative](double x, double y, double scale) {
    EXPECT_NEAR(x, y, relative * std::max({std::abs(x), std::abs(y), scale, 1e-9}));
  };
  near(a.total_probability, b.total_probability, 0.0);
  near(a.total_intensity, b.total_intensity, 0.0);
  ASSERT_EQ(a.targets.size(), b.targets.size());
  for (std::size_t k = 0; k < a.targets.size(); ++k) {
    const double n = b.targets[k].responsibility;
    near(a.targets[k].responsibility, n, 0.0);
    near(a.targets[k].mass_inside, b.targets[k].mass_inside, 0.0);
    for (int i = 0; i < 2; ++i) {
      near(a.targets[k].first[i], b.targets[k].first[i], n);
      near(a.targets[k].second[i], b.targets[k].second[i], 0.0);
    }
  }
}

const std::vector<CellModel>& models() {
  static const std::vector<CellModel> kModels{
      {{31.7, 20.2}, {7.6, 7.6}, 0.5},   // on the target
      {{2.0, 38.0}, {4.0, 2.0}, 0.2},    // on a corner of cells near a corner of the frame
      {{33.0, 24.0}, {9.0, 12.0}, 0.1},  // overlapping the first
  };
  return kModels;
}

class Forms : public ::testing::TestWithParam<Truncation> {};

TEST_P(Forms, PerCellSeparableAndSparseAgree) {
  core::Random random(1000);
  for (const double decibels : {0.5, 3.0, 5.0}) {
    const IntensityFrame frame = noisy_frame(60, 40, 26, 16, 12, 8, random);
    const double threshold = displayed_threshold(frame.noise_level, decibels);
    Expectation reference;
    for (const CellForm form : {CellForm::per_cell, CellForm::separable, CellForm::sparse}) {
      const auto e_step = make_cell_expectation(form, GetParam());
      e_step->prepare(frame, threshold);
      const Expectation& result = e_step->evaluate(0.2, models());
      if (form == CellForm::per_cell) reference = result;
      expect_same(result, reference, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Forms, ::testing::Values(Truncation::impute, Truncation::zero));

TEST(CellExpectation, GatedEqualsSparseWhereTheGateHoldsTheModel) {
  core::Random random(1001);
  const IntensityFrame frame = noisy_frame(120, 90, 26, 16, 12, 8, random);
  const auto sparse = make_cell_expectation(CellForm::sparse, Truncation::zero);
  const auto gated = make_cell_expectation(CellForm::gated, Truncation::zero, {9.0, 2, 8});
  for (const auto& e_step : {sparse.get(), gated.get()})
    e_step->prepare(frame, displayed_threshold(frame.noise_level, 5.0));
  expect_same(gated->evaluate(0.2, models()), sparse->evaluate(0.2, models()), 1e-9);
}

TEST(CellExpectation, GatedLearnsTheBackgroundOutsideFromSampledRows) {
  const IntensityFrame frame{200, 160, std::vector<double>(32000, 2.0)};
  const auto gated = make_cell_expectation(CellForm::gated, Truncation::zero);
  gated->prepare(frame, 1.0);
  const std::vector<CellModel> one{{{100.0, 80.0}, {4.0, 4.0}, 0.5}};
  // Every cell holds 2, so that the frame holds 64000; the gate's share of the sampled rows is an estimate.
  EXPECT_NEAR(gated->evaluate(0.5, one).total_intensity, 64000.0, 0.02 * 64000.0);
}

TEST(CellExpectation, CountsOneIntegralPerExpressionCellAndAxis) {
  const IntensityFrame frame{200, 200, std::vector<double>(40000, 1.0)};
  const std::vector<CellModel> one{{{100.0, 100.0}, {8.0, 8.0}, 0.95}};
  const auto count = [&](CellForm form) {
    const auto e_step = make_cell_expectation(form, Truncation::impute);
    e_step->prepare(frame, 0.5);
    e_step->evaluate(0.05, one);
    return e_step->num_integrals();
  };
  EXPECT_EQ(count(CellForm::per_cell), 240000);  // 3 expressions x 2 axes x 40000 cells; printed twice that
  EXPECT_EQ(count(CellForm::separable), 1200);   // 3 x (200 + 200); printed 2400
  EXPECT_EQ(count(CellForm::sparse), 1200);
}

TEST(CellExpectation, ExpectedIntensitiesAddUpToTheDisplayedTotal) {
  // Under zero truncation sum_k weight_k n_k + background share = ||Z||: nothing is invented or lost.
  core::Random random(1002);
  const IntensityFrame frame = noisy_frame(60, 40, 26, 16, 12, 8, random);
  const auto e_step = make_cell_expectation(CellForm::sparse, Truncation::zero);
  e_step->prepare(frame, 0.0);
  const std::vector<CellModel> one{{{32.0, 20.0}, {7.6, 7.6}, 0.5}};
  const Expectation& result = e_step->evaluate(0.5, one);
  EXPECT_LT(0.5 * result.targets[0].responsibility, result.total_intensity);
  EXPECT_GT(0.5 * result.targets[0].responsibility, 96 * 5.0);  // most of the 96 cells of about 7
}

TEST(CellExpectation, AnEmptyFrameGivesZerosAndNoNaN) {
  const IntensityFrame frame{30, 20, std::vector<double>(600, 0.0)};
  const std::vector<CellModel> one{{{15.0, 10.0}, {4.0, 4.0}, 0.5}};
  for (const CellForm form : {CellForm::per_cell, CellForm::separable, CellForm::sparse, CellForm::gated}) {
    const auto e_step = make_cell_expectation(form, Truncation::zero);
    e_step->prepare(frame, 3.0);
    const Expectation& result = e_step->evaluate(0.5, one);
    EXPECT_EQ(result.total_intensity, 0.0);
    EXPECT_EQ(result.targets[0].responsibility, 0.0);
    EXPECT_EQ(result.targets[0].first, Eigen::Vector2d::Zero());
  }
}

TEST(CellExpectation, GatedChecksTheCellsThatItReads) {
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

TEST(CellExpectation, GatedRefusesTheRefill) {
  EXPECT_THROW(make_cell_expectation(CellForm::gated, Truncation::impute), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
