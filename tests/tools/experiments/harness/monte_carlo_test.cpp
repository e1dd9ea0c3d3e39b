#include "tools/experiments/harness/monte_carlo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/input_error.hpp"
#include "tests/tools/experiments/harness/dice_experiment.hpp"

namespace lookout::tools {
namespace {

MonteCarloOptions options_with(int runs, int jobs) {
  MonteCarloOptions options;
  options.runs = runs;
  options.jobs = jobs;
  return options;
}

TEST(MonteCarlo, ResultsDoNotDependOnTheJobs) {
  const DiceExperiment dice;
  const auto one = run_monte_carlo(dice, "dice", options_with(200, 1));
  const auto many = run_monte_carlo(dice, "dice", options_with(200, 7));
  ASSERT_EQ(one.cells.size(), 3u);
  for (std::size_t i = 0; i < one.cells.size(); ++i)
    EXPECT_EQ(one.cells[i].metrics.at("eyes").mean, many.cells[i].metrics.at("eyes").mean);
}

TEST(MonteCarlo, MeanAndIntervalOfADie) {
  const auto results = run_monte_carlo(DiceExperiment(), "dice", options_with(4000, 2));
  const Estimate eyes = results.cells[0].metrics.at("eyes");
  EXPECT_NEAR(eyes.mean, 3.5, 2.0 * eyes.ci95);
  EXPECT_NEAR(eyes.ci95, 1.96 * std::sqrt(35.0 / 12.0 / 4000.0), 0.003);  // variance of a fair die: 35/12
  EXPECT_EQ(results.cells[2].metrics.at("eyes").runs, 10);                // capped
}

TEST(MonteCarlo, PoolsByWeightAndBySquares) {
  // Rates 1/1 and 0/3 pool to 1/4, not to their mean 1/2.
  EXPECT_DOUBLE_EQ(pool({Metric(1.0, 1.0), Metric(0.0, 3.0)}, Pooling::mean).mean, 0.25);
  EXPECT_DOUBLE_EQ(pool({3.0, 4.0}, Pooling::root_mean_square).mean, std::sqrt(12.5));
  EXPECT_EQ(pool({2.0, std::nan("")}, Pooling::mean).runs, 1);
}

// Parts (3, 0) and (0, 4): each run's own total is 3 and 4, mean 3.5; the norm of the means is
// sqrt(1.5^2 + 2^2) = 2.5. Along (1.5, 2) / 2.5 the runs have 1.8 and 3.2.
TEST(MonteCarlo, NormOfMeansIsThePapersTotal) {
  const Estimate total = norm_of_means({3.0, 0.0}, {0.0, 4.0});
  EXPECT_DOUBLE_EQ(total.mean, 2.5);
  EXPECT_DOUBLE_EQ(total.ci95, pool({1.8, 3.2}, Pooling::mean).ci95);
  EXPECT_EQ(norm_of_means({0.0, 0.0}, {0.0, 0.0}).mean, 0.0);
}

/// Two runs with the parts of the test above.
class PartsExperiment : public DiceExperiment {
 public:
  std::vector<Cell> cells() const override { return {{"parts", {}, {}}}; }
  Metrics run(const Cell&, std::uint64_t, int run) const override {
    return {{"ospa", run == 0 ? 3.0 : 4.0},
            {"ospa_localization", run == 0 ? 3.0 : 0.0},
            {"ospa_cardinality", run == 0 ? 0.0 : 4.0}};
  }
};

TEST(MonteCarlo, BothStatisticsOfOspaStandSideBySide) {
  const auto metrics = run_monte_carlo(PartsExperiment(), "parts", options_with(2, 1)).cells[0].metrics;
  EXPECT_DOUBLE_EQ(metrics.at("ospa").mean, 3.5);
  EXPECT_DOUBLE_EQ(metrics.at("ospa_of_means").mean, 2.5);
}

// Student's t with two degrees of freedom: its .975 quantile is 4.302653 (any table).
TEST(MonteCarlo, FewRunsHaveTheWiderIntervalOfStudent) {
  EXPECT_NEAR(pool({1.0, 2.0, 3.0}, Pooling::mean).ci95, 4.302653 / std::sqrt(3.0), 1e-5);
  EXPECT_TRUE(std::isnan(pool({1.0}, Pooling::mean).ci95));
  EXPECT_NEAR(half_width_95(1.0, 1'000'000), 1.959964, 1e-5);  // the normal's
}

TEST(MonteCarlo, FiltersOrWithinAKeyAndBetweenKeys) {
  const auto cells = DiceExperiment().cells();
  const auto passing = [&](std::vector<std::string> words) {
    int count = 0;
    for (const auto& cell : cells) count += passes(cell, parse_filters(words)) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(passing({}), 3);
  EXPECT_EQ(passing({"sides=6", "sides=12.0"}), 2);
  EXPECT_EQ(passing({"colour=red", "method=die"}), 1);
  EXPECT_EQ(passing({"height=3"}), 0);
  EXPECT_THROW(parse_filters({"sides"}), core::InputError);
}

TEST(MonteCarlo, NothingLeftIsAnError) {
  MonteCarloOptions options = options_with(1, 1);
  options.only = {{"sides", "7"}};
  EXPECT_THROW(run_monte_carlo(DiceExperiment(), "dice", options), core::InputError);
}

class BrokenExperiment : public DiceExperiment {
  Metrics run(const Cell&, std::uint64_t, int) const override { throw std::runtime_error("broken die"); }
};

TEST(MonteCarlo, AFailureInAThreadComesOut) {
  EXPECT_THROW(run_monte_carlo(BrokenExperiment(), "dice", options_with(50, 3)), std::runtime_error);
}

}  // namespace
}  // namespace lookout::tools
