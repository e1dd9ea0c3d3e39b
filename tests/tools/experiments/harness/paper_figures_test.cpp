#include "tools/experiments/harness/paper_figures.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

// [Yan2018] Table 4, P_F = .5, P_M = .3: CSHT 2.79 m, SHT 21.39 m; Table 6, sigma 5: 2.85 m.
TEST(PaperFigures, FindsTheCellOfItsParameters) {
  const PaperFigures paper("yan2018_window_tables.csv");
  Parameters cell{{"p_false_alarm", 0.5}, {"p_miss", 0.3}, {"sigma", 3.0}};
  EXPECT_DOUBLE_EQ(paper.at("csht", cell).at("position_ospa"), 2.79);
  EXPECT_DOUBLE_EQ(paper.at("sht", cell).at("position_ospa"), 21.39);
  cell = {{"p_false_alarm", 0.3}, {"p_miss", 0.3}, {"sigma", 5.0}};
  EXPECT_DOUBLE_EQ(paper.at("csht", cell).at("position_ospa"), 2.85);
}

TEST(PaperFigures, HasNothingForOtherCells) {
  const PaperFigures paper("yan2018_window_tables.csv");
  EXPECT_TRUE(paper.at("csht", {{"p_false_alarm", 0.2}, {"p_miss", 0.3}, {"sigma", 3.0}}).empty());
  EXPECT_TRUE(paper.at("joint", {{"p_false_alarm", 0.5}, {"p_miss", 0.3}, {"sigma", 3.0}}).empty());
}

}  // namespace
}  // namespace lookout::tools
