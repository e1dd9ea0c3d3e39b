#include "tools/experiments/track_before_detect/image_sea_run.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tools/experiments/track_before_detect/image_sea_scene.hpp"

namespace lookout::tools {
namespace {

/// Four seconds at a level that every method finds, in coarse bins, so that all five cost little.
sonar_sim::Scene short_scene() {
  auto scene = image_sea_scene("plain", {20.0, 0.4}, 401, 0);
  scene.duration = 4.0;
  return scene;
}

TEST(ImageSeaRun, EveryMethodAnswersEveryPingAndFindsATarget) {
  for (const auto method : image_sea_methods()) {
    const AnsweredRun run = track_images(std::string(method), short_scene(), 401, 0);
    ASSERT_EQ(run.pings.size(), 8u) << method;  // a ping each half second
    EXPECT_FALSE(run.pings.back().tracks.empty()) << method;
    EXPECT_GT(run.time_ms, 0.0) << method;
  }
}

TEST(ImageSeaRun, OnlookersSeeEveryPingAndItsReturns) {
  int pings = 0, scans = 0;
  track_images("detect+joint", short_scene(), 401, 0,
               {[&](const sonar_sim::SimulatedScan&) { ++pings; }, [&](const core::SonarScan&) { ++scans; }});
  EXPECT_EQ(pings, 8);
  EXPECT_EQ(scans, 8);
}

TEST(ImageSeaRun, RefusesAMethodThatItDoesNotKnow) {
  EXPECT_THROW(track_images("detect", short_scene(), 401, 0), std::invalid_argument);
}

/// A target at rest, a track `off` it with a variance of 1 in each part of the state, for so many pings.
AnsweredRun answered(double off, std::size_t pings) {
  AnsweredRun run;
  for (std::size_t k = 0; k < pings; ++k) {
    AnsweredPing ping;
    ping.truth.utime = core::microseconds(0.5 * static_cast<double>(k));
    ping.truth.targets.push_back({1, {10.0, 0.0}, {0.0, 0.0}, true});
    core::Track track;
    track.id = 1;
    track.status = core::TrackStatus::confirmed;
    track.state << 10.0 + off, 0.0, 0.0, 0.0;
    track.covariance.setIdentity();
    ping.tracks.push_back(track);
    run.pings.push_back(ping);
  }
  return run;
}

TEST(ImageSeaRun, ScoresATrackBesideItsTarget) {
  Metrics metrics = score_images(answered(2.0, 41));
  EXPECT_NEAR(metrics["ospa"].value, 2.0, 1e-9);
  EXPECT_NEAR(metrics["rmse"].value, 2.0, 1e-9);
  EXPECT_NEAR(metrics["nees"].value, 1.0, 1e-9);  // 2^2 / 1 / 4
  EXPECT_EQ(metrics["confirmed_share"].value, 1.0);
  EXPECT_EQ(metrics["false_per_100_pings"].value, 0.0);
}

TEST(ImageSeaRun, CountsATrackBeyondTheGateAsFalse) {
  Metrics metrics = score_images(answered(7.0, 41));
  EXPECT_EQ(metrics["confirmed_share"].value, 0.0);
  EXPECT_EQ(metrics.count("rmse"), 0u);
  EXPECT_NEAR(metrics["false_per_100_pings"].value, 5.0,
              1e-9);  // one in the 20 intervals after the first 20 pings
}

}  // namespace
}  // namespace lookout::tools
