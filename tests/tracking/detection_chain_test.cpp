#include "tracking/detection_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/files/recording.hpp"
#include "tests/tracking/track_before_detect/image_scene.hpp"

namespace lookout::tracking {
namespace {

ChainParams chain_of(const std::string& estimator, const std::string& tracker) {
  ChainParams params;
  params.estimator.name = estimator;
  params.tracker.name = tracker;
  return params;
}

/// What a chain says of the pings of a scene.
struct Outcome {
  std::vector<core::TrackList> tracks;
  std::vector<core::SonarScan> scans;
  IntakeCounts counts;
  core::SonarParams sensor;
};

DetectionParams told() {
  DetectionParams params;
  params.echo.pulse_length = 0.92;               // Of the scene's Gaussian pulse of sigma 0.55 m.
  params.echo.beam_width = core::radians(1.33);  // Of its line array with a null at 1.5 degrees.
  return params;
}

Outcome outcome_of(const std::vector<core::PosedImage>& pings, const ChainParams& params,
                   const GivenFigures& which = {}) {
  Outcome outcome;
  DetectionChain chain(
      told(), params, which,
      [&](const PingResult& result) {
        outcome.tracks.push_back({result.utime, {result.tracks.begin(), result.tracks.end()}});
      },
      [](const std::string&) {}, [&](const core::SonarScan& scan) { outcome.scans.push_back(scan); });
  for (const auto& ping : pings) {
    chain.add(core::VehicleState{ping.image.utime, {}, {0.0, 0.0}});
    chain.add(ping.image);
  }
  chain.finish();
  outcome.counts = chain.counts();
  outcome.sensor = chain.sensor();
  return outcome;
}

// Each sonar has a detector that remembers images: ids without end would take memory without end.
TEST(StreamDetector, LeavesTheImagesOfMoreSonarsThanAVehicleHas) {
  std::vector<std::string> lines;
  StreamDetector detector(told(), [&](const std::string& line) { lines.push_back(line); });
  core::SonarImage image;
  image.bearings = {-0.01, 0.0, 0.01};
  image.range_step = 1.0;
  image.num_bins = 3;
  image.intensity.assign(9, 1.0);
  for (int sonar = 0; sonar < 100; ++sonar) {
    image.sensor_id = sonar;
    EXPECT_EQ(detector.detect(image) != nullptr, sonar < 64) << sonar;
  }
  EXPECT_EQ(detector.damaged(), 36);
  ASSERT_EQ(lines.size(), 6u);  // 1, 2, 4, ... 32.
  EXPECT_EQ(lines[0], "image 0 rejected: more sonars than 64 on one vehicle (1 so far)");
  image.sensor_id = 5;
  EXPECT_NE(detector.detect(image), nullptr);
}

std::vector<core::PosedImage> one_target(double duration) {
  return pings_of(
      sonar_scene("  - {id: 1, north: 70.0, east: -20.0, north_velocity: -1.0, east_velocity: 0.8}\n",
                  duration, 16.0),
      1021);
}

/// Pings of the later half with one confirmed track, and that within 3 m of the target.
int followed(const Outcome& outcome) {
  int count = 0;
  for (std::size_t k = outcome.tracks.size() / 2; k < outcome.tracks.size(); ++k) {
    const double t = core::seconds(outcome.tracks[k].utime);
    int confirmed = 0, near = 0;
    for (const auto& track : outcome.tracks[k].tracks) {
      if (track.status != core::TrackStatus::confirmed) continue;
      ++confirmed;
      if ((track.state.head<2>() - Eigen::Vector2d(70.0 - t, -20.0 + 0.8 * t)).norm() < 3.0) ++near;
    }
    if (confirmed == 1 && near == 1) ++count;
  }
  return count;
}

TEST(DetectionChain, JointFollowsATargetFromImagesToTracks) {
  const auto pings = one_target(30.0);
  const Outcome outcome = outcome_of(pings, chain_of("joint", "joint"));
  EXPECT_EQ(outcome.counts.accepted, static_cast<std::int64_t>(pings.size()));
  EXPECT_GE(followed(outcome), 27);  // Of 30.
}

TEST(DetectionChain, CshtDoesToo) {
  EXPECT_GE(followed(outcome_of(one_target(16.0), chain_of("csht", "csht"))), 13);  // Of 16.
}

TEST(DetectionChain, GivesTheTracksOfItsOwnScans) {
  const auto pings = one_target(10.0);
  const Outcome outcome = outcome_of(pings, chain_of("joint", "joint"));
  ChainParams params = chain_of("joint", "joint");
  params.sensor = outcome.sensor;
  std::vector<core::TrackList> tracks;
  TrackingChain chain(params, [&](const PingResult& result) {
    tracks.push_back({result.utime, {result.tracks.begin(), result.tracks.end()}});
  });
  for (const auto& scan : outcome.scans) {
    chain.add(core::VehicleState{scan.utime, {}, {0.0, 0.0}});
    chain.add(scan);
  }
  chain.finish();
  ASSERT_EQ(tracks.size(), outcome.tracks.size());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    ASSERT_EQ(tracks[k].tracks.size(), outcome.tracks[k].tracks.size());
    for (std::size_t i = 0; i < tracks[k].tracks.size(); ++i)
      EXPECT_EQ(tracks[k].tracks[i].state, outcome.tracks[k].tracks[i].state);
  }
}

TEST(DetectionChain, WhatIsGivenOfTheSensorStands) {
  ChainParams params = chain_of("joint", "joint");
  params.sensor.range_sigma = 0.7;
  const Outcome outcome = outcome_of(one_target(1.0), params, {.range_sigma = true});
  EXPECT_EQ(outcome.sensor.range_sigma, 0.7);
  EXPECT_NEAR(outcome.sensor.clutter_per_scan.value(), 9.0, 1e-9);  // 0.1 x 90 beams.
  EXPECT_LT(outcome.sensor.bearing_sigma.value(), core::radians(0.5));
}

TEST(DetectionChain, ADamagedImageIsCountedAndLeftOut) {
  auto pings = one_target(2.0);
  pings[1].image.range_step = -1.0;
  pings[2].image.intensity.pop_back();
  const Outcome outcome = outcome_of(pings, chain_of("joint", "joint"));
  EXPECT_EQ(outcome.counts.damaged, 2);
  EXPECT_EQ(outcome.counts.received, static_cast<std::int64_t>(pings.size()));
  EXPECT_EQ(outcome.tracks.size(), pings.size() - 2);
}

}  // namespace
}  // namespace lookout::tracking
