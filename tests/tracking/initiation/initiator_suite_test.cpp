// The edge cases of a track initiator, one suite over all registered methods.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "tests/tracking/initiation/initiator_test_scene.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

using test::Course;
using test::SceneOptions;

constexpr double kPi = std::numbers::pi;

class InitiatorSuite : public testing::TestWithParam<std::string> {
 protected:
  /// The window that suits the method: 7 scans for [Fan2018]'s methods, 3 or 4 for the others.
  int scans() const { return make_initiator(GetParam(), test::config_for_tests())->window_scans(); }
  SceneOptions options() const {
    SceneOptions options;
    options.scans = scans();
    return options;
  }
  const StartedTracks& start(const PlotWindow& window) {
    method_ = make_initiator(GetParam(), test::config_for_tests());
    return method_->start(window);
  }
  /// The best track for a course: its error in position at its own time [m], large where there is none.
  static double nearest_error(const StartedTracks& started, const Course& course) {
    double nearest = 1e9;
    for (const StartedTrack& track : started.tracks) {
      const Eigen::Vector2d truth = course.start + track.last_time * course.velocity;
      nearest = std::min(
          nearest, (track.state.head<2>() - truth).norm() + (track.state.tail<2>() - course.velocity).norm());
    }
    return nearest;
  }

  core::Random random_{1001};
  std::unique_ptr<Initiator> method_;
};

Course course_of(const Eigen::Vector2d& start, double heading, double speed = 250.0) {
  return {start, speed * Eigen::Vector2d(std::cos(heading), std::sin(heading))};
}

TEST_P(InitiatorSuite, FindsALineInEveryOctantAndAlongBothAxes) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const Course course = course_of({700.0, -913.0}, degrees * kPi / 180.0);
    const StartedTracks& started = start(test::scene_of({course}, options(), random_));
    ASSERT_GE(started.tracks.size(), 1u) << degrees;
    // Noise-free plots of one target and nothing else: the fit is exact.
    EXPECT_LT(nearest_error(started, course), 1e-6) << degrees;
  }
}

TEST_P(InitiatorSuite, ThetaWrapsAndRhoKeepsItsSign) {
  for (const double theta : {1e-4, kPi - 1e-4}) {
    for (const double side : {-1.0, 1.0}) {
      const Course course = course_of({side * 1487.0, -613.0}, theta + kPi / 2);
      const StartedTracks& started = start(test::scene_of({course}, options(), random_));
      ASSERT_GE(started.tracks.size(), 1u);
      double least = 1e9;
      for (const StartedTrack& track : started.tracks)
        least = std::min(least, std::abs(track.line.offset_of(course.start)));
      // Half the diagonal of the coarsest grid (60 m rows, 0.9 degree columns over 1.6 km) is about 60 m.
      EXPECT_LT(least, 80.0) << theta << " " << side;
    }
  }
}

TEST_P(InitiatorSuite, SurvivesEmptyScansAndAnEmptyWindow) {
  EXPECT_TRUE(start(PlotWindow{}).tracks.empty());
  PlotWindow empty;
  for (int k = 0; k < 7; ++k) empty.begin_scan(2.0 * k);
  EXPECT_TRUE(start(empty).tracks.empty());
}

TEST_P(InitiatorSuite, OnePlotOrOneScanIsNoTrack) {
  SceneOptions one = options();
  one.scans = 1;
  EXPECT_TRUE(
      start(test::scene_of({course_of({0, 0}, 1.0), course_of({50, 9}, 2.0)}, one, random_)).tracks.empty());
  PlotWindow single;
  for (int k = 0; k < 7; ++k) single.begin_scan(2.0 * k);
  single.add(Plot{});
  EXPECT_TRUE(start(single).tracks.empty());
}

TEST_P(InitiatorSuite, TwoScansAreTooFewForAllMethods) {
  if (GetParam() == "sequence_ht") GTEST_SKIP() << "declares whatever line it finds, by design";
  SceneOptions two = options();
  two.scans = 2;
  EXPECT_TRUE(start(test::scene_of({course_of({0, 0}, 1.0)}, two, random_)).tracks.empty());
}

TEST_P(InitiatorSuite, DuplicatePlotsDoNoHarm) {
  const Course course = course_of({-800.0, 300.0}, 0.4);
  const StartedTracks& started = start(test::scene_of({course, course, course}, options(), random_));
  EXPECT_LT(nearest_error(started, course), 1e-6);
}

TEST_P(InitiatorSuite, PointsAtTheOriginDoNoHarm) {
  const Course through_origin = course_of({0.0, 0.0}, 0.7);
  EXPECT_LT(nearest_error(start(test::scene_of({through_origin}, options(), random_)), through_origin), 1e-6);
  const Course resting{{0.0, 0.0}, {0.0, 0.0}};
  for (const StartedTrack& track : start(test::scene_of({resting, resting}, options(), random_)).tracks)
    EXPECT_TRUE(track.state.allFinite());
}

TEST_P(InitiatorSuite, FindsAHundredTargets) {
  std::vector<Course> courses;
  for (int i = 0; i < 100; ++i)
    courses.push_back(
        course_of({-4500.0 + 1000.0 * (i % 10), -4500.0 + 1000.0 * (i / 10)}, 0.21 * i, 150.0 + i));
  const PlotWindow window = test::scene_of(courses, options(), random_);
  const StartedTracks& started = start(window);
  EXPECT_TRUE(started.refusal.empty());
  int found = 0;
  for (const Course& course : courses) found += nearest_error(started, course) < 1.0 ? 1 : 0;
  // Every method but those that are known to drown in crossing lines finds most of them.
  const bool drowns =
      GetParam() == "ht" || GetParam() == "mht_ti" || GetParam() == "sequence_ht" || GetParam() == "fpht";
  EXPECT_GE(found, drowns ? 0 : 60);
}

/// Forty scans: more than the bits of a mask, and than the papers' windows.
TEST_P(InitiatorSuite, ALongWindowIsServed) {
  constexpr int kScans = 40;
  const Course course = course_of({-3000.0, 500.0}, 0.3, 150.0);
  SceneOptions forty = options();
  forty.scans = kScans;
  InitiatorConfig config = test::config_for_tests();
  config.window_scans = kScans;
  config.min_plots = kScans;
  config.sensor_range = 20e3;
  method_ = make_initiator(GetParam(), config);
  const StartedTracks& started = method_->start(test::scene_of({course}, forty, random_));
  EXPECT_EQ(started.refusal, "");
  ASSERT_GE(started.tracks.size(), 1u);
  EXPECT_LT(nearest_error(started, course), 1e-6);
}

TEST_P(InitiatorSuite, SaysItsLeastNumberOfScans) {
  const auto method = make_initiator(GetParam(), test::config_for_tests());
  EXPECT_LE(method->least_scans(), method->window_scans());
  EXPECT_GE(method->least_scans(), 3);
}

TEST_P(InitiatorSuite, TenThousandPlotsAScanEndSoon) {
  SceneOptions flood = options();
  flood.clutter = 10'000;
  const PlotWindow window = test::scene_of({}, flood, random_);
  const auto begin = std::chrono::steady_clock::now();
  const StartedTracks& started = start(window);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LT(seconds, 30.0);
  for (const StartedTrack& track : started.tracks) EXPECT_TRUE(track.state.allFinite());
  EXPECT_TRUE(started.refusal.empty() || started.tracks.empty()) << started.refusal;
}

TEST_P(InitiatorSuite, TracksAreWellFormed) {
  SceneOptions cluttered = options();
  cluttered.clutter = 15;
  cluttered.noisy = true;
  const PlotWindow window =
      test::scene_of({course_of({0, 900}, 2.0), course_of({-500, 0}, 5.0)}, cluttered, random_);
  const StartedTracks& started = start(window);
  for (const StartedTrack& track : started.tracks) {
    const auto plots = started.plots_of(track);
    ASSERT_GE(plots.size(), 2u);
    EXPECT_EQ(track.first_scan, window.plot(plots.front()).scan);
    EXPECT_EQ(track.last_scan, window.plot(plots.back()).scan);
    EXPECT_TRUE(std::is_sorted(plots.begin(), plots.end()));
    EXPECT_GE(track.line.theta, 0.0);
    EXPECT_LT(track.line.theta, kPi);
    EXPECT_GT(track.covariance.diagonal().minCoeff(), 0.0);
  }
}

TEST_P(InitiatorSuite, SameWindowSameAnswer) {
  SceneOptions cluttered = options();
  cluttered.clutter = 20;
  const PlotWindow window = test::scene_of({course_of({0, 900}, 2.0)}, cluttered, random_);
  const StartedTracks first = start(window);
  const StartedTracks& again = method_->start(window);
  EXPECT_EQ(first.plots, again.plots);
  ASSERT_EQ(first.tracks.size(), again.tracks.size());
  for (std::size_t i = 0; i < first.tracks.size(); ++i)
    EXPECT_EQ(first.tracks[i].state, again.tracks[i].state);
}

INSTANTIATE_TEST_SUITE_P(AllMethods, InitiatorSuite, testing::ValuesIn(initiator_names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace lookout::tracking
