#include "tracking/track_before_detect/frames/cell_expectation.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/frame_maker.hpp"
#include "tests/tracking/track_before_detect/frames/expectations.hpp"

namespace lookout::tracking {
namespace {

class Forms : public ::testing::TestWithParam<Truncation> {};

TEST_P(Forms, PerCellSeparableAndSparseAgree) {
  core::Random random(1000);
  for (const double decibels : {0.5, 3.0, 5.0}) {
    const IntensityFrame frame = noisy_frame(60, 40, {26, 16}, random);
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

TEST(CellExpectation, CountsOneIntegralPerExpressionCellAndAxis) {
  const IntensityFrame frame{200, 200, std::vector<double>(40000, 1.0)};
  const std::vector<CellModel> one{{{100.0, 100.0}, {8.0, 8.0}, 0.95}};
  const auto count = [&](CellForm form, CellMoments moments = CellMoments::second) {
    const auto e_step = make_cell_expectation(form, Truncation::impute);
    e_step->set_moments(moments);
    e_step->prepare(frame, 0.5);
    e_step->evaluate(0.05, one);
    return e_step->num_integrals();
  };
  EXPECT_EQ(count(CellForm::per_cell), 240000);  // 3 expressions x 2 axes x 40000 cells; printed twice that
  EXPECT_EQ(count(CellForm::separable), 1200);   // 3 x (200 + 200); printed 2400
  EXPECT_EQ(count(CellForm::sparse), 1200);
  // Without the second moments, which one iteration with R fixed never asks for: two expressions of the
  // three.
  EXPECT_EQ(count(CellForm::per_cell, CellMoments::first), 160000);
  EXPECT_EQ(count(CellForm::separable, CellMoments::first), 800);
  EXPECT_EQ(count(CellForm::sparse, CellMoments::first), 800);
}

TEST(CellExpectation, ExpectedIntensitiesAddUpToTheDisplayedTotal) {
  // Under zero truncation sum_k weight_k n_k + background share = ||Z||: nothing is invented or lost.
  core::Random random(1002);
  const IntensityFrame frame = noisy_frame(60, 40, {26, 16}, random);
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

}  // namespace
}  // namespace lookout::tracking
