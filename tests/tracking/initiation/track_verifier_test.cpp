#include "tracking/initiation/track_verifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSigma = 1.0;

Plot plot_at(const Eigen::Vector2d& position) {
  Plot plot;
  plot.position = position;
  plot.noise = kSigma * kSigma * Eigen::Matrix2d::Identity();
  plot.clutter_density = 1e-4;
  return plot;
}

/// Ten scans, half a second apart, of a target that is 1 m farther east in each; `missed` have no plot.
PlotWindow course(std::initializer_list<int> missed, double step = 1.0) {
  PlotWindow window;
  for (int k = 0; k < 10; ++k) {
    window.begin_scan(0.5 * k);
    if (std::ranges::find(missed, k) == missed.end()) window.add(plot_at({20.0, step * k}));
  }
  return window;
}

/// What a method says of that target by scans 2 to 4: roughly where and how it goes.
StartedTrack proposal(double speed = 2.0) {
  StartedTrack track;
  track.state << 20.3, 4.2, 0.0, speed;
  track.covariance = kSigma * kSigma * Eigen::Matrix4d::Identity();
  track.last_time = 2.0;
  return track;
}

TEST(TrackVerifier, FindsTheCourseInAllScans) {
  TrackVerifier verifier({});
  const VerifiedCourse* found = verifier.verify(course({4}), proposal());
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->plots, (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(TrackVerifier, WantsKOfN) {
  TrackVerifier verifier({});  // 7 of 10
  EXPECT_NE(verifier.verify(course({0, 3, 8}), proposal()), nullptr);
  EXPECT_EQ(verifier.verify(course({0, 3, 5, 8}), proposal()), nullptr);
}

TEST(TrackVerifier, RefusesWhatIsTooFast) {
  TrackVerifierParams params;
  params.speeds = {0.0, 1.0};  // The target makes 2 m/s, known to .25 m/s by ten plots.
  EXPECT_EQ(TrackVerifier(params).verify(course({}), proposal()), nullptr);
  EXPECT_NE(TrackVerifier({}).verify(course({}), proposal()), nullptr);
}

/// The same course among so much clutter that it proves nothing: a plot on every square metre.
TEST(TrackVerifier, RefusesWhatClutterWouldFitAsWell) {
  TrackVerifierParams params;
  params.clutter_per_area = 1.0;
  EXPECT_EQ(TrackVerifier(params).verify(course({}), proposal()), nullptr);
}

// Every pair of plots of the last scan and one three scans before is proposed, in clutter alone: what stands
// is less than the expectation that was allowed, 0.2 a window.
TEST(TrackVerifier, ClutterAloneStandsNoMoreOftenThanAllowed) {
  core::Random random(1005);
  TrackVerifierParams params;
  params.max_false_tracks = 0.2;
  params.min_plots = 5;
  TrackVerifier verifier(params);
  constexpr int kWindows = 200;
  constexpr double kHalf = 40.0;
  constexpr int kClutter = 12;
  int stood = 0;
  for (int run = 0; run < kWindows; ++run) {
    PlotWindow window;
    for (int k = 0; k < 10; ++k) {
      window.begin_scan(0.5 * k);
      for (int i = 0; i < kClutter; ++i) {
        Plot plot = plot_at({random.uniform(-kHalf, kHalf), random.uniform(-kHalf, kHalf)});
        plot.clutter_density = kClutter / (4.0 * kHalf * kHalf);
        window.add(plot);
      }
    }
    bool any = false;
    for (int i = window.first(6); i < window.end(6); ++i) {
      for (int j = window.first(9); j < window.end(9); ++j) {
        const TrackFit fit = two_point_start(window.plot(i), window.plot(j), {});
        StartedTrack track;
        track.state = fit.track.state;
        track.covariance = fit.track.covariance;
        track.last_time = fit.time;
        any = verifier.verify(window, track) != nullptr || any;
      }
    }
    stood += any ? 1 : 0;
  }
  EXPECT_LE(stood, 0.2 * kWindows);
}

TEST(TrackVerifier, RefusesBadParameters) {
  TrackVerifierParams params;
  params.min_plots = 2;
  EXPECT_THROW(TrackVerifier{params}, std::invalid_argument);
  params = {};
  params.max_false_tracks = 0.0;
  EXPECT_THROW(TrackVerifier{params}, std::invalid_argument);
  params = {};
  params.speeds.max = std::numeric_limits<double>::infinity();
  EXPECT_THROW(TrackVerifier{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
