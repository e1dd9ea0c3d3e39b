#include "tracking/initiation/sliding_initiator.hpp"

#include <gtest/gtest.h>

#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

SlidingInitiator four_of_five() {
  InitiatorConfig config;
  config.window_scans = 5;
  config.min_plots = 4;
  SlidingParams params;
  params.window_scans = 5;
  return {make_initiator("vct", config), params};
}

std::vector<Plot> plot_at(double x, double y) {
  Plot plot;
  plot.noise = 25.0 * Eigen::Matrix2d::Identity();
  plot.position = {x, y};
  return {plot};
}

/// 60 scans of one target with every seventh plot missing.
TEST(SlidingInitiator, ATargetStartsOnce) {
  SlidingInitiator sliding = four_of_five();
  int started = 0;
  for (int k = 0; k < 60; ++k) {
    const auto plots = k % 7 == 3 ? std::vector<Plot>{} : plot_at(500.0 * k, 30.0 * k);
    started += static_cast<int>(sliding.add_scan(2.0 * k, plots).tracks.size());
  }
  EXPECT_EQ(started, 1);
}

TEST(SlidingInitiator, ATargetThatComesBackElsewhereStartsAgain) {
  SlidingInitiator sliding = four_of_five();
  int started = 0;
  for (int k = 0; k < 30; ++k)
    started +=
        static_cast<int>(sliding.add_scan(2.0 * k, plot_at(500.0 * k, k < 15 ? 0.0 : 5e3)).tracks.size());
  EXPECT_EQ(started, 2);
}

/// Three plots would be enough for `modified_logic`, but a window of three scans is not full.
TEST(SlidingInitiator, AWindowThatIsNotFullStartsNothing) {
  InitiatorConfig config;
  config.position_sigma = 5.0;
  SlidingParams params;
  params.window_scans = 4;
  SlidingInitiator sliding(make_initiator("modified_logic", config), params);
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(sliding.add_scan(5.0 * k, plot_at(2500.0 * k, 0.0)).tracks.empty()) << k;
  EXPECT_EQ(sliding.add_scan(15.0, plot_at(7500.0, 0.0)).tracks.size(), 1u);
}

TEST(SlidingInitiator, VctStartsFromItsFewestPlotsOn) {
  SlidingInitiator sliding = four_of_five();
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(sliding.add_scan(2.0 * k, plot_at(500.0 * k, 0.0)).tracks.empty()) << k;
  EXPECT_EQ(sliding.add_scan(6.0, plot_at(1500.0, 0.0)).tracks.size(), 1u);
}

TEST(SlidingInitiator, RefusesTimeThatRunsBackwards) {
  SlidingInitiator sliding = four_of_five();
  sliding.add_scan(2.0, {});
  EXPECT_THROW(sliding.add_scan(1.0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
