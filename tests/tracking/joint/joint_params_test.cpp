#include "tracking/joint/joint_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

TEST(JointTrackerParams, DefaultsAreValid) {
  EXPECT_NO_THROW(validate(JointTrackerParams{}));
}

// One value out of range in each nested struct, and the text that shows it.
struct BadValue {
  const char* shown;
  std::function<void(JointTrackerParams&)> spoil;
};

class JointTrackerParamsRefused : public ::testing::TestWithParam<BadValue> {};

TEST_P(JointTrackerParamsRefused, ShowsTheValue) {
  JointTrackerParams params;
  GetParam().spoil(params);
  try {
    validate(params);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().shown), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    EachStruct, JointTrackerParamsRefused,
    ::testing::Values(
        BadValue{"log_floor", [](auto& p) { p.sensor.log_floor = 1.0; }},
        BadValue{"trajectories must be in [32, 4096], got 4", [](auto& p) { p.cloud.trajectories = 4; }},
        BadValue{"trusted_share", [](auto& p) { p.cloud.trusted_share = 1.0; }},
        BadValue{"tempering_step", [](auto& p) { p.cloud.tempering_step = 1.0; }},
        BadValue{"speed_edge must be > 0, got 0", [](auto& p) { p.prior.speed_edge = 0.0; }},
        BadValue{"past_stride must be >= 1, got 0", [](auto& p) { p.claims.past_stride = 0; }},
        BadValue{"least_nats", [](auto& p) { p.birth.begin_nats = p.birth.least_nats; }},
        BadValue{"manoeuvre rounds", [](auto& p) { p.manoeuvre.rounds = 0; }},
        BadValue{"better_nats must be >= 0, got -2", [](auto& p) { p.birth.better_nats = -2.0; }},
        BadValue{"same_target", [](auto& p) { p.birth.same_target = 0.0; }},
        BadValue{"manoeuvre prior", [](auto& p) { p.manoeuvre.prior = 0.0; }},
        BadValue{"in_view_share", [](auto& p) { p.life.in_view_share = 0.0; }},
        BadValue{"manoeuvre memory_s", [](auto& p) { p.manoeuvre.memory_s = 7.0; }},
        BadValue{"curved_share", [](auto& p) { p.manoeuvre.curved_share = 0.0; }},
        BadValue{"present_rounds", [](auto& p) { p.manoeuvre.present_rounds = 0; }},
        BadValue{"constant_velocity_nats", [](auto& p) { p.manoeuvre.constant_velocity_nats = -1.0; }},
        BadValue{"constant_turn_nats", [](auto& p) { p.manoeuvre.constant_turn_nats = -1.0; }},
        BadValue{"sudden_scans", [](auto& p) { p.manoeuvre.sudden_scans = 0; }},
        BadValue{"return_s", [](auto& p) { p.life.return_s = -1.0; }},
        BadValue{"first_log_odds", [](auto& p) { p.report.first_log_odds = NAN; }},
        BadValue{"published_tentative", [](auto& p) { p.report.published_tentative = 1.5; }},
        BadValue{"heading steps must be >= 1, got 0", [](auto& p) { p.heading.steps = 0; }},
        BadValue{"target_samples", [](auto& p) { p.learning.target_samples = 0; }}));

// A beam of one degree is 126 m wide, as a standard deviation, at 25 km: with a cut-off of 20 m a target
// there was never worth a report. The usual sonars keep theirs.
TEST(JointTrackerParams, TheCutoffOfAReportIsNoNarrowerThanTheSensorsError) {
  core::SonarParams far;
  far.max_range = 25'000.0;
  far.range_sigma = 20.0;
  EXPECT_NEAR(for_sensor({}, far).report.cutoff, 2.5 * 0.5 * 25'000.0 * far.bearing_sigma_or_default(), 1e-9);
  EXPECT_EQ(for_sensor({}, core::SonarParams()).report.cutoff, 20.0);
}

}  // namespace
}  // namespace lookout::tracking
