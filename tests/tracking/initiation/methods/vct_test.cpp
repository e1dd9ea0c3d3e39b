#include "tracking/initiation/methods/vct.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

using test::Course;
using test::SceneOptions;

VctParams six_of_seven() {
  VctParams params;
  params.motion.acceleration_sigma = 0.0;
  params.window_scans = 7;
  params.min_plots = 6;
  return params;
}

TEST(Vct, SpeedSeparatesTwoTargetsOnOneLine) {
  core::Random random(1006);
  const std::vector<Course> courses{{{-2000, 100}, {300, 0}}, {{2000, 100}, {-150, 0}}};
  VctInitiator vct(six_of_seven());
  EXPECT_EQ(vct.start(test::scene_of(courses, {}, random)).tracks.size(), 2u);
}

/// The threshold is the number of false chains expected per window: on clutter alone no more than that are
/// declared, within three standard errors of a Poisson number.
TEST(Vct, ClutterAloneStaysBelowTheDeclaredNumber) {
  core::Random random(1007);
  SceneOptions options;
  options.clutter = 60;
  options.scans = 4;
  options.sigma = 20.0;
  VctParams params;
  params.max_false_tracks = 0.2;
  VctInitiator vct(params);
  constexpr int kRuns = 200;
  int declared = 0;
  for (int run = 0; run < kRuns; ++run)
    declared += static_cast<int>(vct.start(test::scene_of({}, options, random)).tracks.size());
  EXPECT_LE(declared, 0.2 * kRuns + 3.0 * std::sqrt(0.2 * kRuns));
}

TEST(Vct, BridgesMissesUpToItsOwnAndNoMore) {
  for (const int missing : {1, 2}) {
    PlotWindow window;
    for (int k = 0; k < 7; ++k) {
      window.begin_scan(2.0 * k);
      Plot plot;
      plot.noise = 25.0 * Eigen::Matrix2d::Identity();
      plot.position = {500.0 * k, -40.0 * k};
      if (k < 3 || k >= 3 + missing) window.add(plot);
    }
    VctInitiator vct(six_of_seven());
    EXPECT_EQ(vct.start(window).tracks.size(), missing == 1 ? 1u : 0u);
  }
}

TEST(Vct, OnePlotServesOneTrack) {
  core::Random random(1008);
  SceneOptions options;
  options.clutter = 80;
  options.noisy = true;
  const PlotWindow window = test::scene_of(
      {{{-1500, 0}, {250, 20}}, {{-1500, 60}, {250, -10}}, {{900, 900}, {-200, -100}}}, options, random);
  VctInitiator vct(six_of_seven());
  auto plots = vct.start(window).plots;
  std::sort(plots.begin(), plots.end());
  EXPECT_EQ(std::adjacent_find(plots.begin(), plots.end()), plots.end());
}

TEST(Vct, RefusesMoreBranchesThanItsBound) {
  core::Random random(1009);
  SceneOptions options;
  options.clutter = 300;
  VctParams params = six_of_seven();
  params.max_branches = 1000;
  VctInitiator vct(params);
  const StartedTracks& started = vct.start(test::scene_of({}, options, random));
  EXPECT_NE(started.refusal.find("more than 1000 branches"), std::string::npos);
  EXPECT_TRUE(started.tracks.empty());
}

/// Four scans of 5 s of a target at 500 m/s that turns at two degrees a second: after 5 s it is 218 m beside
/// its straight course, eleven sigmas of 20 m.
PlotWindow turning_target(double rate) {
  PlotWindow window;
  const double radius = 500.0 / rate;
  for (int k = 0; k < 4; ++k) {
    window.begin_scan(5.0 * k);
    Plot plot;
    plot.noise = 400.0 * Eigen::Matrix2d::Identity();
    plot.clutter_density = 1e-8;
    const double angle = rate * 5.0 * k;
    plot.position = radius * Eigen::Vector2d(std::sin(angle), 1.0 - std::cos(angle));
    window.add(plot);
  }
  return window;
}

TEST(Vct, FollowsTurnsOfEitherHandWhereTheyAreAllowed) {
  VctParams params;
  params.speeds = kZengSpeeds;
  constexpr double kDegree = 3.14159265358979 / 180.0;
  for (const double rate : {2.0 * kDegree, -1.8 * kDegree}) {
    const PlotWindow window = turning_target(rate);
    params.max_turn_rate = 0.0;
    EXPECT_TRUE(VctInitiator(params).start(window).tracks.empty()) << rate;
    params.max_turn_rate = 2.0 * kDegree;
    VctInitiator vct(params);
    const auto& tracks = vct.start(window).tracks;
    ASSERT_EQ(tracks.size(), 1u) << rate;
    // The velocity after 15 s of turning.
    const Eigen::Vector2d velocity(500.0 * std::cos(15.0 * rate), 500.0 * std::sin(15.0 * rate));
    EXPECT_LT((tracks[0].state.tail<2>() - velocity).norm(), 20.0) << rate;
  }
}

TEST(Vct, WaysOfTurningAreCountedAmongTheChances) {
  core::Random random(1010);
  SceneOptions options;
  options.clutter = 60;
  options.scans = 4;
  options.sigma = 20.0;
  VctParams params;
  params.max_false_tracks = 0.2;
  params.max_turn_rate = 0.07;  // Four degrees a second: seventeen ways.
  VctInitiator vct(params);
  constexpr int kRuns = 200;
  int declared = 0;
  for (int run = 0; run < kRuns; ++run)
    declared += static_cast<int>(vct.start(test::scene_of({}, options, random)).tracks.size());
  EXPECT_LE(declared, 0.2 * kRuns + 3.0 * std::sqrt(0.2 * kRuns));
}

TEST(Vct, RefusesParametersOutOfRange) {
  VctParams params;
  params.min_plots = 5;  // of a window of 4
  EXPECT_THROW(VctInitiator{params}, std::invalid_argument);
  params = {};
  params.margin_sigmas = -1.0;
  EXPECT_THROW(VctInitiator{params}, std::invalid_argument);
  params = {};
  params.clutter_per_area = 0.0;
  EXPECT_THROW(VctInitiator{params}, std::invalid_argument);
  params = {};
  params.speeds = {};  // no largest speed
  EXPECT_THROW(VctInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
