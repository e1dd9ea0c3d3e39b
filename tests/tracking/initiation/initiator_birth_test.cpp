#include "tracking/initiation/initiator_birth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

/// One target at 2 m/s eastwards, seen without error from a sonar at rest 5 km from the origin of the earth
/// frame.
core::PosedScan scan_of(int k, const core::SonarParams& sonar) {
  core::PosedScan posed;
  posed.T_earth_sonar = {5000.0, -3000.0, 0.0};
  posed.scan.utime = 500'000 * k;
  posed.scan.sequence = k;
  posed.scan.first_bearing = sonar.first_bearing;
  posed.scan.bearing_step = sonar.bearing_step;
  posed.scan.num_beams = sonar.num_beams;
  posed.scan.max_range = sonar.max_range;
  const Eigen::Vector2d offset(60.0, -10.0 + 1.0 * k);
  posed.scan.returns.push_back({std::atan2(offset.y(), offset.x()), offset.norm(), 1.0});
  return posed;
}

std::vector<core::MotionElement> run(const std::string& name, std::span<const core::Track> tracks) {
  core::SonarParams sonar;
  sonar.range_sigma = 0.2;
  sonar.bearing_sigma = 0.001;
  InitiatorBirth birth(name, {}, sonar);
  std::vector<core::MotionElement> born;
  for (int k = 0; k < 20; ++k) {
    for (const auto& element : birth.propose(scan_of(k, sonar), tracks)) {
      born.push_back(element);
      const Eigen::Vector2d truth(5060.0, -3010.0 + 1.0 * k);
      EXPECT_LT((element.position - truth).norm(), 1.0) << name;
      EXPECT_NEAR(element.velocity.y(), 2.0, 0.3) << name;
    }
  }
  return born;
}

TEST(InitiatorBirth, EveryMethodStartsAPlainTargetFarFromTheOrigin) {
  for (const auto& name : initiator_names()) EXPECT_GE(run(name, {}).size(), 1u) << name;
}

// Errors of 3 m, 3 m/s at most, a scan every half second: two plots of one target differ by 3 sqrt(2) m of
// errors, the fastest moves as far in 1.4 s, that is, in three scans.
TEST(ForSonar, GatesAndCellsFollowTheErrors) {
  const core::SonarParams sonar;
  const InitiatorConfig gates = for_sonar(sonar, "ag_fht", {});
  EXPECT_NEAR(*gates.gate_margin, 3.0 * std::sqrt(2.0) * 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(*gates.max_turn, std::numbers::pi);  // A step shorter than its errors has any direction.
  EXPECT_EQ(*gates.window_scans, 4);                    // The paper's own.
  EXPECT_DOUBLE_EQ(*gates.rho_step, 6.0);               // Two sigmas.
  // Three steps of 1.5 s at 3 m/s and the margin, to either side.
  EXPECT_NEAR(*gates.sensor_range, 2.0 * (13.5 + *gates.gate_margin), 1e-12);
  EXPECT_EQ(*for_sonar(sonar, "nht_ti", {}).window_scans, 7);
}

// Two degrees at 150 m are 5.2 m across the line of sight, more than the 3 m along it.
TEST(ForSonar, TheBearingErrorCounts) {
  core::SonarParams sonar;
  sonar.bearing_sigma = core::radians(2.0);
  const double across = core::radians(2.0) * sonar.max_range;
  const InitiatorConfig config = for_sonar(sonar, "ag_fht", {});
  EXPECT_NEAR(*config.gate_margin, 3.0 * std::sqrt(2.0) * across, 1e-12);
  EXPECT_NEAR(*config.rho_step, 2.0 * across, 1e-12);
}

TEST(ForSonar, MinPlotsIsThatOfTheProof) {
  InitiatorConfig given;
  given.min_plots = 9;
  // Nine of the ten scans of the proof; of its own four scans the method proposes from three plots on.
  const InitiatorConfig config = for_sonar({}, "ag_fht", given);
  EXPECT_EQ(config.proof_plots, 9);
  EXPECT_EQ(config.min_plots, 3);
  EXPECT_EQ(for_sonar({}, "vct", given).min_plots, 9);
  given.min_plots = 11;
  EXPECT_THROW(for_sonar({}, "ag_fht", given), std::invalid_argument);
}

TEST(ForSonar, WhatTheUserGaveStays) {
  InitiatorConfig given;
  given.gate_margin = 1.0;
  given.max_turn = 0.5;
  given.window_scans = 5;
  given.rho_step = 0.7;
  const InitiatorConfig config = for_sonar({}, "modified_logic", given);
  EXPECT_EQ(config.gate_margin, 1.0);
  EXPECT_EQ(config.max_turn, 0.5);
  EXPECT_EQ(config.window_scans, 5);
  EXPECT_EQ(config.rho_step, 0.7);
}

TEST(InitiatorBirth, ProposesNothingThatATrackExplains) {
  core::Track track;
  track.state << 5060.0, -3000.0, 0.0, 2.0;
  track.covariance = 400.0 * Eigen::Matrix4d::Identity();
  EXPECT_TRUE(run("vct", std::span(&track, 1)).empty());
}

TEST(InitiatorBirth, TheTrackersOwnMethodIsNone) {
  EXPECT_EQ(make_birth("", "joint", {}, {}), nullptr);
  EXPECT_EQ(make_birth("joint", "joint", {}, {}), nullptr);
  EXPECT_NE(make_birth("vct", "joint", {}, {}), nullptr);
  EXPECT_THROW(make_birth("joint", "csht", {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
