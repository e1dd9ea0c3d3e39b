#include "tools/experiments/track_before_detect/hpmht_curves.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/harness/monte_carlo.hpp"

namespace lookout::tools {
namespace {

TEST(HpmhtCurves, ALowerThresholdHoldsMoreAndReportsMore) {
  MonteCarloOptions options;
  options.seed = 301;
  options.runs = 1;
  options.jobs = 1;
  options.only = {{"method", "mf_nn"}, {"rule", "4 of 6"}, {"snr_db", "8"}};
  const auto experiment = make_hpmht_curves();
  const auto cells = run_monte_carlo(*experiment, "hpmht-curves", options).cells;
  ASSERT_EQ(cells.size(), 5u);
  EXPECT_LT(cells.front().cell.parameters.number("threshold"),
            cells.back().cell.parameters.number("threshold"));
  EXPECT_GE(cells.front().metrics.at("in_track").mean, cells.back().metrics.at("in_track").mean);
  EXPECT_GT(cells.front().metrics.at("false_per_scan").mean, cells.back().metrics.at("false_per_scan").mean);
}

}  // namespace
}  // namespace lookout::tools
