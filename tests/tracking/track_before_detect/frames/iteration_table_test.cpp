// How many iterations the E-step needs to pull a mean from 4 px off to within 0.5 px of a 12 x 8 target:
// docs/notes/start_and_level_of_h_pmht.md, iteration table, mean of ten frames.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/track_before_detect/frame_maker.hpp"
#include "tracking/track_before_detect/frames/cell_expectation.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMostIterations = 40;

/// One M-step for a static target: the mean moves to the centroid, the weights follow Eq. (15).
void iterate(CellExpectation& e_step, Truncation truncation, CellModel& model, double& background) {
  const Expectation& e = e_step.evaluate(background, {&model, 1});
  const double all = background + model.weight * e.targets[0].mass_inside;
  const double refilled = truncation == Truncation::impute ? all / e.total_probability : 1.0;
  model.mean += e.targets[0].first / e.targets[0].responsibility;
  model.weight *= e.targets[0].responsibility / (e.total_intensity * refilled);
  background = 1.0 - model.weight;
}

int iterations_needed(Truncation truncation, double decibels, std::uint64_t seed) {
  core::Random random(seed);
  const IntensityFrame frame = noisy_frame(200, 200, {94, 96}, random);
  const auto e_step = make_cell_expectation(CellForm::sparse, truncation);
  e_step->prepare(frame, displayed_threshold(frame.noise_level, decibels));
  const Eigen::Vector2d centre(100.0, 100.0);
  const double variance = 96.0 / (4.0 * M_PI);
  CellModel model{centre + Eigen::Vector2d(4.0, 0.0), {variance, variance}, 0.95};
  double background = 0.05;
  int iterations = 0;
  while (iterations < kMostIterations && (model.mean - centre).norm() >= 0.5) {
    iterate(*e_step, truncation, model, background);
    ++iterations;
  }
  return iterations;
}

double mean_iterations(Truncation truncation, double decibels) {
  double sum = 0.0;
  for (std::uint64_t seed = 1000; seed < 1010; ++seed) sum += iterations_needed(truncation, decibels, seed);
  return sum / 10.0;
}

TEST(IterationTable, DarkCellsNeedOneOrTwo) {
  const std::pair<double, double> table[]{{0.5, 2.0}, {1, 1.5}, {2, 1}, {3, 1}, {5, 1}, {7, 1}};
  for (const auto& [decibels, expected] : table)
    EXPECT_NEAR(mean_iterations(Truncation::zero, decibels), expected, 1.0) << decibels << " dB";
}

TEST(IterationTable, RefilledCellsNeedThreeOrFourFromTwoDecibelsUp) {
  const std::pair<double, double> table[]{{2, 4}, {3, 3}, {5, 3}, {7, 4}};
  for (const auto& [decibels, expected] : table)
    EXPECT_NEAR(mean_iterations(Truncation::impute, decibels), expected, 1.0) << decibels << " dB";
}

TEST(IterationTable, RefilledCellsBarelyMoveAtALowThreshold) {
  EXPECT_GT(mean_iterations(Truncation::impute, 0.5), 10.0);
  EXPECT_GT(mean_iterations(Truncation::impute, 1.0), 10.0);
}

}  // namespace
}  // namespace lookout::tracking
