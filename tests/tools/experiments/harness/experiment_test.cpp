#include "tools/experiments/harness/experiment.hpp"

#include <gtest/gtest.h>

#include "tests/tools/experiments/harness/dice_experiment.hpp"

namespace lookout::tools {
namespace {

TEST(Parameters, KeepTheirOrderAndReplaceByName) {
  Parameters parameters{{"sigma", 3.0}, {"clutter", "light"}};
  parameters.set("p_miss", 0.1);
  parameters.set("sigma", 1.0);
  ASSERT_EQ(parameters.values().size(), 3u);
  EXPECT_EQ(parameters.values()[0].first, "sigma");
  EXPECT_EQ(parameters.number("sigma"), 1.0);
  EXPECT_EQ(parameters.text("clutter"), "light");
  EXPECT_FALSE(parameters.has("snr_db"));
  EXPECT_THROW(parameters.number("snr_db"), std::out_of_range);
  EXPECT_THROW(parameters.number("clutter"), std::bad_variant_access);
}

TEST(Experiment, ARunDependsOnSeedAndNumberAlone) {
  const DiceExperiment dice;
  const Cell cell = dice.cells().front();
  EXPECT_EQ(dice.run(cell, 1000, 3).at("eyes").value, dice.run(cell, 1000, 3).at("eyes").value);
  int different = 0;
  for (int run = 0; run < 20; ++run)
    different += dice.run(cell, 1000, run).at("eyes").value != dice.run(cell, 1001, run).at("eyes").value;
  EXPECT_GT(different, 0);
}

TEST(Drawn, ShowsTheNearestOfTheCellsThatAreLeft) {
  Drawn drawn;
  drawn.cells = {{"a", {{"p", 0.1}, {"s", 3.0}}, {}},
                 {"a", {{"p", 0.3}, {"s", 3.0}}, {}},
                 {"b", {{"p", 0.3}, {"s", 3.0}}, {}},
                 {"b", {{"p", 0.3}, {"s", 1.0}}, {}}};
  const Cell& cell = nearest_cell(drawn.cells, {{"p", 0.3}, {"s", 3.0}});
  EXPECT_EQ(cell.parameters.number("p"), 0.3);
  EXPECT_EQ(drawn.like(cell).size(), 2U);  // one of each method
  EXPECT_EQ(drawn.of_method("b").size(), 2U);
  EXPECT_EQ(nearest_cell(drawn.cells, {{"p", 0.9}, {"s", 1.0}}).method, "b");
}

}  // namespace
}  // namespace lookout::tools
