#include "tracking/joint/joint_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "tests/support/joint_pipeline.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

core::SonarParams known_sonar(double miss, double false_alarm) {
  core::SonarParams sonar;
  sonar.miss_probability = miss;
  sonar.false_alarm_probability = false_alarm;
  return sonar;
}

std::vector<core::Track> confirmed(std::span<const core::Track> tracks) {
  std::vector<core::Track> result;
  for (const auto& track : tracks)
    if (track.status == core::TrackStatus::confirmed) result.push_back(track);
  return result;
}

TEST(JointTracker, FollowsOneTargetAndCallsItOneTarget) {
  ScanPipeline tracker = joint_pipeline(known_sonar(0.1, 0.1), 1);
  std::span<const core::Track> tracks;
  for (int k = 0; k < 60; ++k) tracks = tracker.step(scan_of(k, {{60.0 + 0.5 * k, 10.0}})).tracks;
  ASSERT_EQ(confirmed(tracks).size(), 1U);
  const core::Track track = confirmed(tracks)[0];
  EXPECT_NEAR(track.state(0), 60.0 + 0.5 * 59, 1.5);
  EXPECT_NEAR(track.state(1), 10.0, 1.5);
  EXPECT_NEAR(track.state(2), 1.0, 0.1);
  EXPECT_GT(track.existence, 0.99);
}

TEST(JointTracker, ConfirmsWithinThreeSecondsInLightClutter) {
  ScanPipeline tracker = joint_pipeline(known_sonar(0.1, 0.1), 1);
  int first = 100;
  for (int k = 0; k < 20; ++k)
    if (!confirmed(tracker.step(scan_of(k, {{60.0 + 0.5 * k, 10.0}})).tracks).empty())
      first = std::min(first, k);
  EXPECT_LE(first, 6);
}

// In how many of 60 scans one confirmed track stands within 3 m of the only target, where each scan's heading
// is off by a degree or so, of beams of one degree.
int followed_with_bad_headings(double heading_sigma) {
  core::SonarParams sonar = known_sonar(0.1, 0.1);
  sonar.heading_sigma = heading_sigma;
  ScanPipeline tracker = joint_pipeline(sonar, 1);
  core::Random random(1000);
  int followed = 0;
  for (int k = 0; k < 60; ++k) {
    core::PosedScan scan = scan_of(k, {{60.0 + 0.5 * k, 10.0}});
    scan.T_earth_sonar.heading = random.gaussian(core::radians(1.0));
    const auto tracks = confirmed(tracker.step(scan).tracks);
    const Eigen::Vector2d truth(60.0 + 0.5 * k, 10.0);
    if (tracks.size() == 1 && (tracks[0].position() - truth).norm() < 3.0) ++followed;
  }
  return followed;
}

TEST(JointTracker, FollowsThroughNoisyHeadingsThatItIsToldOf) {
  const int told = followed_with_bad_headings(core::radians(1.0));
  EXPECT_GE(told, 50);
  EXPECT_GT(told, followed_with_bad_headings(0.0) + 10);
}

// A rock 60 m ahead, heard at each scan: in cell 30 of 60 bearings and 20 of 50 ranges of 3 m.
TEST(JointTracker, ShowsWhatItHasLearntOfTheClutter) {
  ScanPipeline tracker = joint_pipeline(known_sonar(0.1, 0.1), 1);
  std::optional<core::ClutterGrid> grid;
  for (int k = 0; k < 80; ++k) grid = tracker.step(scan_of(k, {{60.2, 0.5}})).clutter_grid();
  ASSERT_TRUE(grid);
  EXPECT_GE(grid->density[30 * 50 + 20], 10);
  EXPECT_EQ(grid->density[10 * 50 + 20], 0);
}

TEST(JointTracker, AnEmptySeaHasNoTracks) {
  ScanPipeline tracker = joint_pipeline(known_sonar(0.1, 0.1), 1);
  std::span<const core::Track> tracks;
  for (int k = 0; k < 40; ++k) tracks = tracker.step(scan_of(k, {})).tracks;
  EXPECT_TRUE(tracks.empty());
}

TEST(JointTracker, SameSeedSameTracks) {
  ScanPipeline first = joint_pipeline(known_sonar(0.1, 0.1), 5),
               second = joint_pipeline(known_sonar(0.1, 0.1), 5);
  for (int k = 0; k < 20; ++k) {
    const auto scan = scan_of(k, {{60.0 + 0.5 * k, 10.0}, {90.0, -30.0}});
    const auto a = first.step(scan).tracks;
    const auto b = second.step(scan).tracks;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].state, b[i].state);
  }
}

// Four targets, which move north, appear in view in the 20th scan and never miss a detection. Were they held
// against the scans before, each would have missed ten: 40 of 160.
TEST(JointTracker, TargetsThatAppearInViewAreNoMissesOfTheScansBefore) {
  const std::vector<Eigen::Vector2d> four{{60, 20}, {90, -40}, {40, 0}, {110, 30}};
  ScanPipeline tracker = joint_pipeline({});
  PingResult result;
  for (int k = 0; k < 60; ++k) {
    std::vector<Eigen::Vector2d> seen;
    if (k >= 20)
      for (const Eigen::Vector2d& target : four) seen.emplace_back(target.x() + 0.4 * (k - 20), target.y());
    result = tracker.step(scan_of(k, seen));
  }
  EXPECT_LT(result.sensor_estimate->miss_probability, 0.2);
}

// Slow drifters of tools/scenarios/two_uuv_acoustic.yaml, before a sonar at rest.
struct Drifter {
  Eigen::Vector2d start, velocity;  // [m], [m/s].
  Eigen::Vector2d at(int scan) const { return start + 0.5 * scan * velocity; }
};
const std::vector<Drifter> kDrifters{
    {{60, -20}, {0.1, 0.08}}, {{90, 30}, {-0.08, -0.05}}, {{110, -10}, {-0.05, 0.1}}};

// Each is missed three times in ten, errs by 3 m and is heard at the border of two beams of one degree; a
// quarter of the scans have a false alarm.
core::PosedScan scan_of_drifters(int k, core::Random& random) {
  std::vector<Eigen::Vector2d> points;
  const auto hear = [&](double bearing_deg, double range) {
    const double bearing = core::radians(std::round(bearing_deg));
    points.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  };
  for (const Drifter& drifter : kDrifters) {
    const Eigen::Vector2d p = drifter.at(k);
    if (!random.bernoulli(0.3))
      hear(core::degrees(std::atan2(p.y(), p.x())), p.norm() + random.gaussian(3.0));
  }
  if (random.bernoulli(0.25)) hear(random.uniform(-44.0, 44.0), random.uniform(5.0, 145.0));
  return scan_of(k, points);
}

// Of the times of the drifters from one minute to three, the share that a confirmed track is within
// 10 m.
double drifters_held(std::uint64_t seed) {
  ScanPipeline tracker = joint_pipeline(core::SonarParams(), seed);
  core::Random random(seed);
  int held = 0, times = 0;
  for (int k = 0; k < 360; ++k) {
    const auto tracks = confirmed(tracker.step(scan_of_drifters(k, random)).tracks);
    for (const Drifter& drifter : kDrifters) {
      if (k < 120) continue;
      ++times;
      held += std::any_of(tracks.begin(), tracks.end(), [&](const core::Track& track) {
        return (track.position() - drifter.at(k)).norm() < 10.0;
      });
    }
  }
  return static_cast<double>(held) / times;
}

// Nothing is told of misses and false alarms. Their own trails priced them as standing things for good, and
// P_M was learnt from what is faster than .3 m/s alone: .43 was held, .84 now. Of seeds 1 to 6 (.60 then, .85
// now) these two differ most.
TEST(JointTracker, HoldsSlowDrifters) {
  EXPECT_GT(0.5 * (drifters_held(1) + drifters_held(4)), 0.7);
}

TEST(JointTracker, RefusesBadParams) {
  JointTrackerParams params;
  params.cloud.trajectories = 4;
  EXPECT_THROW(JointTracker(params, {}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
