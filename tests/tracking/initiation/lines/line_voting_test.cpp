#include "tracking/initiation/lines/line_voting.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

const LineGrid kGrid(100, 200, 1000.0);

std::span<const LineVote> declared(const SparseAccumulator& votes, std::vector<LineVote>& candidates) {
  LineVotingParams params;
  params.theta_step = kGrid.theta_step();
  params.rho_step = kGrid.rho_step();
  return declared_lines(kGrid, votes, params, candidates);
}

TEST(LineVoting, ANeighbourhoodIsTwoTolerancesWide) {
  const LineVotingParams params;  // e_r = 20 m over cells of 5 m; 0.004 over 0.001 rad: [Fan2018] Eq. (28).
  EXPECT_EQ(params.rho_radius(), 8);
  EXPECT_EQ(params.theta_radius(), 8);
}

// Noise-free plots on both sides of rho = 0: the papers' grid has a border there, the centred one a row.
TEST(LineVoting, ACentredGridHasARowAroundTheOrigin) {
  PlotWindow window;
  window.begin_scan(0.0);
  Plot plot;
  plot.position = {100.0, 0.0};
  window.add(plot);
  LineVotingParams params;
  const LineGrid border = grid_over(window, params);
  EXPECT_NE(border.row_of(-1e-9), border.row_of(1e-9));
  params.centred_rows = true;
  const LineGrid centred = grid_over(window, params);
  EXPECT_EQ(centred.row_of(-2.4), centred.row_of(2.4));  // Rows of 5 m.
  EXPECT_NE(centred.row_of(2.4), centred.row_of(2.6));
  EXPECT_NEAR(centred.rho_step(), params.rho_step, 1e-12);
}

TEST(LineVoting, DeclaresPeaksAboveHalfOfTheHighestOneANeighbourhood) {
  SparseAccumulator votes;
  votes.add(kGrid.index({10, 50}), 6.0);   // The highest,
  votes.add(kGrid.index({11, 50}), 5.0);   // one beside it,
  votes.add(kGrid.index({60, 120}), 3.0);  // another of just half,
  votes.add(kGrid.index({80, 20}), 2.9);   // and one of less.
  std::vector<LineVote> candidates;
  const auto lines = declared(votes, candidates);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].cell, (LineCell{10, 50}));
  EXPECT_EQ(lines[1].cell, (LineCell{60, 120}));
}

TEST(LineVoting, ANeighbourhoodGoesOverTheEndOfTheta) {
  SparseAccumulator votes;
  votes.add(kGrid.index({99, 149}), 6.0);  // One column further is column 0 with row 199 - 149 = 50.
  votes.add(kGrid.index({0, 50}), 5.0);
  std::vector<LineVote> candidates;
  EXPECT_EQ(declared(votes, candidates).size(), 1u);
}

TEST(LineVoting, NothingIsDeclaredWhereNothingVoted) {
  std::vector<LineVote> candidates;
  EXPECT_TRUE(declared({}, candidates).empty());
}

TEST(LineVoting, RefusesParametersOutOfRange) {
  LineVotingParams params;
  EXPECT_NO_THROW(params.validate());
  params.rho_step = 0.0;
  EXPECT_THROW(params.validate(), std::invalid_argument);
  params = {};
  params.window_scans = 1;
  EXPECT_THROW(params.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
