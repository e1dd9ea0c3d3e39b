#include "tracking/initiation/methods/ag_fht.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(AgFht, ACandidateScoresItsHitsAndItsMemberships) {
  // Four plots 2.5 km apart along the line through the centre of cell (100, 250).
  const LineGrid grid(200, 400, 150e3);
  const NormalLine line = grid.centre({100, 250});
  PlotWindow window;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.position = line.rho * line.normal() + (2500.0 * k - 3750.0) * line.direction();
    plot.noise = 1e4 * Eigen::Matrix2d::Identity();
    window.add(plot);
  }
  const auto method = make_ag_fht({});
  const StartedTracks& started = method->start(window);
  ASSERT_EQ(started.tracks.size(), 1u);
  EXPECT_NEAR(started.tracks[0].line.rho, line.rho, 1e-6);
  // [Zeng2023] Eq. (15): 4 hits, and of each plot 1 + 2 e^-1/2 + 2 e^-2 over five columns; at most 0.16 rows
  // of 750 m off the line there (3.75 km times 0.0314 rad), which costs less than 0.05 in all.
  EXPECT_NEAR(started.tracks[0].score, 4.0 + 4.0 * (1.0 + 2.0 * std::exp(-0.5) + 2.0 * std::exp(-2.0)), 0.05);
}

TEST(AgFht, PlotsOfACandidateAndPlotsOfACellAreTwoNumbers) {
  // Rows of 100 m; three plots in the middle of one, the fourth 900 m to the side: no line of any column has
  // all four within 50 m (at best 225 m).
  const LineGrid grid(200, 3000, 150e3);
  const NormalLine line = grid.centre({100, 1800});
  PlotWindow window;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.position =
        (line.rho + (k == 3 ? 900.0 : 0.0)) * line.normal() + (2500.0 * k - 2500.0) * line.direction();
    plot.noise = 9e4 * Eigen::Matrix2d::Identity();
    window.add(plot);
  }
  InitiatorConfig config;
  config.rho_step = 100.0;
  config.min_plots = 4;
  EXPECT_EQ(make_ag_fht(config)->start(window).tracks.size(), 1u);
  config.min_hits = 4;
  EXPECT_EQ(make_ag_fht(config)->start(window).tracks.size(), 0u);
  config.min_hits = 5;
  EXPECT_THROW(make_ag_fht(config), std::invalid_argument);
}

TEST(AgFht, FewerThanThreePlotsAreNoCandidate) {
  core::Random random(1024);
  test::SceneOptions options;
  options.scans = 2;
  options.period = 5.0;
  const auto method = make_ag_fht({});
  EXPECT_TRUE(method->start(test::scene_of({{{0, 0}, {500, 0}}}, options, random)).tracks.empty());
}

TEST(AgFht, RefusesParametersOutOfRange) {
  AgFhtParams params;
  params.min_plots = 1;
  EXPECT_THROW(AgFhtInitiator{params}, std::invalid_argument);
  params = {};
  params.window_scans = 1;
  EXPECT_THROW(AgFhtInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
