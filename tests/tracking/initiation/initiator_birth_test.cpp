#include "tracking/initiation/initiator_birth.hpp"

#include <gtest/gtest.h>

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
