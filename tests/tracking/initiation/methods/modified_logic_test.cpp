#include "tracking/initiation/methods/modified_logic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

/// Plots 5 s apart at 500 m/s that turn by `turn` degrees at the third scan; the fourth is left out where
/// `misses_last`.
PlotWindow window_of(double turn, bool misses_last) {
  const double angle = turn * std::numbers::pi / 180.0;
  const Eigen::Vector2d second_leg(2500.0 * std::cos(angle), 2500.0 * std::sin(angle));
  PlotWindow window;
  Plot plot;
  plot.noise = 1e6 * Eigen::Matrix2d::Identity();  // So wide an ellipse that the turn alone decides.
  plot.position = {10e3, 10e3};
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    if (k < 3 || !misses_last) window.add(plot);
    plot.position += k == 0 ? Eigen::Vector2d(2500.0, 0.0) : second_leg;
  }
  return window;
}

TEST(ModifiedLogic, ThreePlotsOfFourScansMakeATrack) {
  const auto method = make_modified_logic({});
  ASSERT_EQ(method->start(window_of(0.0, true)).tracks.size(), 1u);
  EXPECT_EQ(method->start(window_of(0.0, true)).tracks[0].num_plots, 3);
  EXPECT_EQ(method->start(window_of(0.0, false)).tracks[0].num_plots, 4);
}

TEST(ModifiedLogic, ATurnOfMoreThanThirtyDegreesIsRefused) {
  const auto method = make_modified_logic({});  // [Zeng2023]: 6 degrees a second for 5 s.
  EXPECT_EQ(method->start(window_of(29.0, true)).tracks.size(), 1u);
  EXPECT_TRUE(method->start(window_of(31.0, true)).tracks.empty());
}

TEST(ModifiedLogic, RefusesParametersOutOfRange) {
  ModifiedLogicParams params;
  params.min_plots = 1;
  EXPECT_THROW(ModifiedLogicInitiator{params}, std::invalid_argument);
  params = {};
  params.window_scans = 1;
  EXPECT_THROW(ModifiedLogicInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
