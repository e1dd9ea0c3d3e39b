#include "tracking/initiation/plots/track_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

PlotWindow noisy_course(core::Random& random) {
  PlotWindow window;
  for (int k = 0; k < 5; ++k) {
    window.begin_scan(2.0 * k);
    Plot plot;
    plot.noise << 9.0, 2.0, 2.0, 4.0;
    plot.position =
        Eigen::Vector2d(10.0 + 40.0 * k, -6.0 * k) + Eigen::Vector2d(random.gaussian(3), random.gaussian(2));
    window.add(plot);
  }
  return window;
}

/// Ordinary weighted least squares over all plots at once, solved as one system.
TEST(TrackFit, EqualsWeightedLeastSquares) {
  core::Random random(1003);
  const PlotWindow window = noisy_course(random);
  const std::array<int, 5> plots{0, 1, 2, 3, 4};
  const TrackFit fit = fit_track(window, plots, MotionModelParams{0.0});
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d weighted = Eigen::Vector4d::Zero();
  for (const Plot& plot : window.plots()) {
    Eigen::Matrix<double, 2, 4> design;
    design << Eigen::Matrix2d::Identity(), (plot.time - 8.0) * Eigen::Matrix2d::Identity();
    information += design.transpose() * plot.noise.inverse() * design;
    weighted += design.transpose() * plot.noise.inverse() * plot.position;
  }
  const Eigen::Vector4d solution = information.ldlt().solve(weighted);
  double chi_square = 0.0;
  for (const Plot& plot : window.plots()) {
    const Eigen::Vector2d residual =
        plot.position - solution.head<2>() - (plot.time - 8.0) * solution.tail<2>();
    chi_square += residual.dot(plot.noise.inverse() * residual);
  }
  EXPECT_LT((fit.track.state - solution).norm(), 1e-8);
  EXPECT_LT((fit.track.covariance - information.inverse()).norm(), 1e-8);
  EXPECT_NEAR(fit.chi_square, chi_square, 1e-8);
}

/// The residuals of n plots have 2 n - 4 degrees of freedom: mean 6 for five.
TEST(TrackFit, ChiSquareHasItsDegreesOfFreedom) {
  core::Random random(1004);
  const std::array<int, 5> plots{0, 1, 2, 3, 4};
  double sum = 0.0;
  constexpr int kRuns = 4000;
  for (int run = 0; run < kRuns; ++run) {
    // The drawn errors are uncorrelated; state so.
    PlotWindow window;
    const PlotWindow drawn = noisy_course(random);
    for (int k = 0; k < 5; ++k) {
      window.begin_scan(drawn.time(k));
      Plot plot = drawn.plot(k);
      plot.noise << 9.0, 0.0, 0.0, 4.0;
      window.add(plot);
    }
    sum += fit_track(window, plots, MotionModelParams{0.0}).chi_square;
  }
  EXPECT_NEAR(sum / kRuns, 6.0, 4.0 * std::sqrt(12.0 / kRuns));
}

TEST(TrackFit, TwoPointStartIsTheDifference) {
  Plot a, b;
  a.position = {1.0, 2.0};
  b.position = {5.0, 0.0};
  b.time = 2.0;
  const TrackFit fit = two_point_start(a, b, MotionModelParams{3.0});
  EXPECT_EQ(fit.track.state, Eigen::Vector4d(5.0, 0.0, 2.0, -1.0));
  // (1 + 1) / 4 of the plots, (3 x 2 / 2)^2 of the acceleration.
  EXPECT_DOUBLE_EQ(fit.track.covariance(2, 2), 0.5 + 9.0);
  EXPECT_DOUBLE_EQ(fit.track.covariance(0, 2), 0.5);
}

TEST(TrackFit, AStartedTrackKnowsItsCourse) {
  PlotWindow window;
  for (int k = 0; k < 3; ++k) {
    window.begin_scan(k);
    Plot plot;
    plot.position = {3.0 * k, 7.0};
    window.add(plot);
  }
  StartedTracks started;
  const std::array<int, 3> plots{0, 1, 2};
  const StartedTrack& track = add_track(window, plots, MotionModelParams{0.0}, 1.5, started);
  EXPECT_NEAR(track.line.rho, 7.0, 1e-9);
  EXPECT_NEAR(track.initial_position().x(), 0.0, 1e-9);
  EXPECT_EQ(track.last_scan, 2);
  EXPECT_DOUBLE_EQ(track.score, 1.5);
}

/// On a circle of 1000 m at 0.1 rad/s, 100 m/s: noise-free plots leave no residual and the exact velocity.
TEST(TrackFit, ATurnOfItsRateFitsExactly) {
  PlotWindow window;
  for (int j = 0; j < 4; ++j) {
    window.begin_scan(3.0 * j);
    Plot plot;
    plot.position = 1000.0 * Eigen::Vector2d(std::sin(0.3 * j), 1.0 - std::cos(0.3 * j));
    window.add(plot);
  }
  const std::vector<int> plots{0, 1, 2, 3};
  const TrackFit fit = fit_track(window, plots, {0.0}, 0.1);
  EXPECT_NEAR(fit.chi_square, 0.0, 1e-9);
  EXPECT_NEAR((fit.track.velocity() - 100.0 * Eigen::Vector2d(std::cos(0.9), std::sin(0.9))).norm(), 0.0,
              1e-6);
  EXPECT_GT(fit_track(window, plots, {0.0}).chi_square, 1000.0);
}

}  // namespace
}  // namespace lookout::tracking
