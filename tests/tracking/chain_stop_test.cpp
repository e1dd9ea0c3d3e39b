// A stop signal while a chain works: the scan in work is left where it is, and all is counted. A predicate
// that says stop at its n-th call stands for the signal, so that no clock plays a part.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/random.hpp"
#include "tests/support/joint_pipeline.hpp"
#include "tests/support/sonar_scene.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {
namespace {

constexpr int kScans = 13;    // At the twelfth, eleven are tracked again: their beams hold several returns.
constexpr int kReturns = 60;  // A scan, in 90 beams.

/// A target that goes north, and false returns all over the fan.
core::PosedScan crowded_scan(int index) {
  core::Random random(static_cast<std::uint64_t>(index) + 1);
  std::vector<Eigen::Vector2d> places{{30.0 + 0.5 * index, 0.0}};
  while (places.size() < kReturns)
    places.push_back(core::from_polar(random.uniform(20.0, 140.0), random.uniform(-0.7, 0.7)));
  return scan_of(index, places);
}

struct Outcome {
  IntakeCounts counts;
  int given = 0;
  std::int64_t calls = 0;
};

Outcome run_until(std::int64_t stop_call) {
  Outcome outcome;
  TrackingChain chain(ChainParams(), [&outcome](const PingResult&) { ++outcome.given; });
  chain.stop_when([&outcome, stop_call] { return ++outcome.calls >= stop_call; });
  for (int k = 0; k < kScans; ++k) {
    const core::PosedScan posed = crowded_scan(k);
    chain.add(core::VehicleState{posed.scan.utime, {}, {0.0, 0.0}});
    chain.add(posed.scan);
  }
  chain.finish();
  outcome.counts = chain.counts();
  return outcome;
}

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

TEST(ChainStop, WhereverItComesEachScanIsGivenOrShed) {
  const Outcome whole = run_until(kNever);
  EXPECT_EQ(whole.given, kScans);
  for (std::int64_t fifth = 0; fifth < 5; ++fifth) {
    const Outcome cut = run_until(1 + fifth * whole.calls / 5);
    EXPECT_EQ(cut.counts.received, kScans);
    EXPECT_EQ(cut.counts.accepted, cut.given) << fifth;
    EXPECT_EQ(cut.counts.accepted + cut.counts.shed, kScans) << fifth;
    EXPECT_GT(cut.counts.shed, 0) << fifth;
    EXPECT_EQ(cut.counts.returns, kReturns * cut.given) << fifth;
    EXPECT_EQ(cut.calls, 1 + fifth * whole.calls / 5);  // Who was told to stop does not ask again.
  }
}

// What is asked often costs little in between: within one crowded scan it is asked dozens of times, and once
// the answer is yes, but for the loops that it ends, no more.
TEST(ChainStop, AScanInWorkIsLeftWhereItIs) {
  constexpr int kBefore = 8;
  core::SonarParams sonar;
  sonar.clutter_per_scan = kReturns;
  sonar.false_alarm_probability.reset();
  for (const std::int64_t stop_call : {kNever, std::int64_t{1}, std::int64_t{20}, std::int64_t{60}}) {
    ScanPipeline pipeline = joint_pipeline(sonar);
    for (int k = 0; k < kBefore; ++k) pipeline.step(crowded_scan(k));
    std::int64_t calls = 0;
    pipeline.stop_when([&calls, stop_call] { return ++calls >= stop_call; });
    pipeline.step(crowded_scan(kBefore));
    if (stop_call == kNever)
      EXPECT_GT(calls, 80);
    else
      EXPECT_LE(calls, stop_call + 8);
  }
}

// The state that is kept at a stop holds the scans that were to be tracked again, tracked or not.
TEST(ChainStop, WhatWasToBeTrackedAgainIsRemembered) {
  std::int64_t calls = 0;
  bool stops = false;
  int given = 0;
  TrackingChain chain(
      ChainParams(), [&given](const PingResult&) { ++given; },
      [&stops](const std::string& line) { stops = stops || line.find("several returns") != line.npos; });
  chain.remember();
  chain.stop_when([&] { return given == 11 && ++calls > 40; });
  for (int k = 0; k < 12; ++k) {
    const core::PosedScan posed = crowded_scan(k);
    chain.add(core::VehicleState{posed.scan.utime, {}, {0.0, 0.0}});
    chain.add(posed.scan);
  }
  EXPECT_TRUE(stops);
  EXPECT_EQ(given, 11);
  EXPECT_EQ(chain.memory().scans.size(), 11u);
  EXPECT_EQ(chain.counts().shed, 1);
}

}  // namespace
}  // namespace lookout::tracking
