#include "tracking/initiation/plots/gate_logic.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

/// Four scans of 5 s of a target at 500 m/s along the first axis, [Zeng2023]; `missed` leaves one out.
PlotWindow zeng_target(int missed = -1) {
  PlotWindow window;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.noise = 1e4 * Eigen::Matrix2d::Identity();
    plot.position = {55e3 + 2500.0 * k, 55e3};
    if (k != missed) window.add(plot);
  }
  return window;
}

TEST(GateLogic, FollowsATargetThroughAllGates) {
  const PlotWindow window = zeng_target();
  GateLogic gates{GateLogicParams{}};
  const auto tracks = gates.run(window);
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].num_plots, 4);
  EXPECT_NEAR(tracks[0].fit.track.state[2], 500.0, 1e-6);
}

TEST(GateLogic, ExtrapolatesTwiceOverOneMissingPlot) {
  for (const int missed : {1, 2}) {
    const PlotWindow window = zeng_target(missed);
    GateLogic gates{GateLogicParams{}};
    const auto tracks = gates.run(window);
    ASSERT_GE(tracks.size(), 1u) << missed;
    EXPECT_EQ(tracks[0].num_plots, 3) << missed;
  }
}

TEST(GateLogic, DropsATrackThatTurnsTooFast) {
  PlotWindow window;
  const double path[4][2] = {{0, 0}, {2500, 0}, {2500, 2500}, {2500, 5000}};
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.position = {path[k][0], path[k][1]};
    window.add(plot);
  }
  GateLogic gates{GateLogicParams{}};
  for (const GateTrack& track : gates.run(window)) EXPECT_LT(track.num_plots, 4);
}

TEST(GateLogic, ATurnMayBeAllowedByItself) {
  PlotWindow window;
  const double path[4][2] = {{0, 0}, {2500, 0}, {2500, 2500}, {2500, 5000}};
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.noise = 1e6 * Eigen::Matrix2d::Identity();
    plot.position = {path[k][0], path[k][1]};
    window.add(plot);
  }
  GateLogicParams params;
  params.limit_turns(1.0);  // 57 degrees: less than the path's 90.
  EXPECT_TRUE(params.fan_gate);
  for (const GateTrack& track : GateLogic(params).run(window)) EXPECT_LT(track.num_plots, 4);
  params.limit_turns(3.0);
  EXPECT_FALSE(params.fan_gate);  // No fan opens around a direction that says nothing.
  GateLogic gates(params);
  EXPECT_EQ(gates.run(window)[0].num_plots, 4);
}

TEST(GateLogic, KnowledgeOfTheCourseRefusesTheOppositeOne) {
  PlotWindow window;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.position = {-2500.0 * k, 0.0};
    window.add(plot);
  }
  GateLogicParams params;
  params.known_course = Eigen::Vector2d(1.0, 0.0);
  params.drop_lonely_roots = true;
  EXPECT_TRUE(GateLogic(params).run(window).empty());
}

/// In the gate of a root at 55 km lie the target's next plot, which is the nearer to the mean speed's 2707 m,
/// and one beside it, from which a second target goes on.
PlotWindow two_in_one_gate() {
  PlotWindow window;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.noise = 1e4 * Eigen::Matrix2d::Identity();
    plot.position = {2600.0 * k, 0.0};
    window.add(plot);
    plot.position = {1000.0, 2000.0 + 2500.0 * (k - 1)};
    if (k > 0) window.add(plot);
  }
  return window;
}

/// Roots by the three readings: one target alone; both; and a root on the first target's own second plot too.
TEST(GateLogic, RootsOfTheSecondScanAreReadInThreeWays) {
  const auto tracks_of = [](NewRoots reading) {
    GateLogicParams params;
    params.new_roots = reading;
    GateLogic gates(params);
    return gates.run(two_in_one_gate()).size();
  };
  EXPECT_EQ(tracks_of(NewRoots::outside_gates), 1u);
  EXPECT_EQ(tracks_of(NewRoots::unclaimed), 2u);
  EXPECT_EQ(tracks_of(NewRoots::all), 3u);
}

TEST(GateLogic, TheVariantsNameSaysTheReading) {
  EXPECT_EQ(new_roots_of("text"), NewRoots::unclaimed);
  EXPECT_EQ(new_roots_of("text_outside_gates"), NewRoots::outside_gates);
  EXPECT_EQ(new_roots_of("polar_all_plots"), NewRoots::all);
}

TEST(GateLogic, RefusesParametersOutOfRange) {
  GateLogicParams params;
  params.gate = 0.0;
  EXPECT_THROW(GateLogic{params}, std::invalid_argument);
  params = {};
  params.max_turn = 0.0;
  EXPECT_THROW(GateLogic{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
