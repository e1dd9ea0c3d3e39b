#include "tracking/initiation/methods/modified_ht.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

/// Tracks of one triple 5 s apart: a leg of 2500 m along the first axis, then one of `length` turned by
/// `turn` degrees.
std::size_t tracks_of(double turn, double length, const InitiatorConfig& config = {}) {
  const double angle = turn * std::numbers::pi / 180.0;
  PlotWindow window;
  Plot plot;
  for (const Eigen::Vector2d& step : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2500.0, 0.0),
                                      Eigen::Vector2d(length * std::cos(angle), length * std::sin(angle))}) {
    window.begin_scan(5.0 * window.num_scans());
    plot.position += step;
    window.add(plot);
  }
  return make_modified_ht(config)->start(window).tracks.size();
}

TEST(ModifiedHt, ZeroCrossingsMayBeThirtyColumnsApart) {
  EXPECT_EQ(tracks_of(26.9, 2500.0), 1u);  // 30 columns of 0.9 degrees.
  EXPECT_EQ(tracks_of(27.1, 2500.0), 0u);
  EXPECT_EQ(tracks_of(-26.9, 2500.0), 1u);
}

TEST(ModifiedHt, LimitsMayBeWidened) {
  InitiatorConfig config;
  config.max_turn = std::numbers::pi;
  EXPECT_EQ(tracks_of(180.0, 2500.0, config), 1u);
  config.gate_margin = 300.0;  // 1365 to 4050 m in 5 s.
  EXPECT_EQ(tracks_of(0.0, 1400.0, config), 1u);
  EXPECT_EQ(tracks_of(0.0, 1300.0, config), 0u);
}

TEST(ModifiedHt, TheMotionDoesNotReverse) {
  EXPECT_EQ(tracks_of(180.0, 2500.0), 0u);  // The same line, so the same crossing.
}

TEST(ModifiedHt, BothLegsKeepTheSpeedLimits) {
  EXPECT_EQ(tracks_of(0.0, 5.0 * 332.0), 0u);  // [Zeng2023]: 333 to 750 m/s.
  EXPECT_EQ(tracks_of(0.0, 5.0 * 334.0), 1u);
  EXPECT_EQ(tracks_of(0.0, 5.0 * 751.0), 0u);
}

}  // namespace
}  // namespace lookout::tracking
