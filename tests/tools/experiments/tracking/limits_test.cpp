#include "tools/experiments/tracking/limits.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

Cell cell_of(const Experiment& experiment, const std::string& situation, double p) {
  for (const auto& cell : experiment.cells()) {
    if (cell.parameters.text("situation") == situation && cell.parameters.number("p_false_alarm") == p)
      return cell;
  }
  throw std::out_of_range(situation);
}

TEST(Limits, AnEasyWindowIsNearTheBound) {
  const auto limits = make_limits();
  const Metrics metrics = limits->run(cell_of(*limits, "window", 0.1), 1000, 0);
  EXPECT_EQ(metrics.at("count_correct").value, 1.0);
  // Nobody beats knowing which detection is whose by more than chance; one window, so loosely.
  EXPECT_GT(metrics.at("efficiency").value, 0.5);
  EXPECT_LT(metrics.at("efficiency").value, 1.5);
}

TEST(Limits, ClutterAloneGivesLittleEvidence) {
  const auto limits = make_limits();
  double sum = 0.0;
  for (int run = 0; run < 5; ++run)
    sum += limits->run(cell_of(*limits, "clutter_only", 0.1), 1000, run).at("evidence").value;
  EXPECT_GE(sum, 0.0);
  EXPECT_LT(sum / 5, 1.0);  // a mean likelihood ratio under clutter is 1; five windows hold no rare peak
}

TEST(Limits, PoolsSquaresWhereErrorsAreSquared) {
  const auto limits = make_limits();
  EXPECT_EQ(limits->pooling("rmse"), Pooling::root_mean_square);
  EXPECT_EQ(limits->pooling("count_correct"), Pooling::mean);
}

}  // namespace
}  // namespace lookout::tools
