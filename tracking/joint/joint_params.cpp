#include "tracking/joint/joint_params.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"
#include "csht/joint/density/sensor_scale.hpp"

namespace lookout::tracking {
namespace {

/// The least cut-off of a report [m at the scale of Table 1]: 2.5 of its errors of position. A narrower one
/// would never report a target that is as uncertain as its sonar is.
constexpr double kLeastCutoff = 7.5;

void validate(const MotionChangeParams& p) {
  core::require(p.window_s > 0.0 && p.window_s <= 30.0, "manoeuvre window_s must be in (0, 30]", p.window_s);
  core::require_inner_share("manoeuvre prior", p.prior);
  core::require_inner_share("curved_share", p.curved_share);
  core::require(p.least_scans >= 1, "least_scans must be >= 1", p.least_scans);
  core::require(p.memory_s >= p.window_s, "manoeuvre memory_s must be >= window_s", p.memory_s);
  core::require(p.rounds >= 1, "manoeuvre rounds must be >= 1", p.rounds);
  core::require(p.present_rounds >= 1, "present_rounds must be >= 1", p.present_rounds);
  core::require(p.position_slack > 0.0, "position_slack must be > 0", p.position_slack);
  core::require(p.velocity_slack > 0.0, "velocity_slack must be > 0", p.velocity_slack);
  core::require(p.acceleration_slack > 0.0, "acceleration_slack must be > 0", p.acceleration_slack);
  core::require(p.turn_slack > 0.0, "turn_slack must be > 0", p.turn_slack);
  core::require_not_negative("constant_velocity_nats", p.constant_velocity_nats);
  core::require(p.redraw_nats > 0.0, "redraw_nats must be > 0", p.redraw_nats);
  core::require(p.young_windows >= 0, "young_windows must be >= 0", p.young_windows);
  core::require(p.sudden_scans >= 1, "sudden_scans must be >= 1", p.sudden_scans);
  core::require_not_negative("hopeless_nats", p.hopeless_nats);
  core::require_not_negative("constant_turn_nats", p.constant_turn_nats);
  core::require_not_negative("constant_acceleration_nats", p.constant_acceleration_nats);
  core::require_inner_share("trusted_share", p.trusted_share);
}

void validate(const LifeParams& p) {
  core::require(p.end_log_odds < 0.0, "end_log_odds must be < 0", p.end_log_odds);
  core::require(p.mean_life_s > 0.0, "mean_life_s must be > 0", p.mean_life_s);
  core::require_not_negative("coast_s", p.coast_s);
  core::require_not_negative("return_s", p.return_s);
  core::require_not_negative("twin_distance", p.twin_distance);
  core::require_not_negative("twin_speed", p.twin_speed);
  core::require_inner_share("in_view_share", p.in_view_share);
  core::require_inner_share("missed_again", p.missed_again);
}

void validate(const ReportParams& p) {
  core::require(p.standing.creep > 0.0, "standing creep must be > 0", p.standing.creep);
  core::require_probability("min_existence", p.min_existence);
  core::require(p.cutoff > 0.0, "cutoff must be > 0", p.cutoff);
  core::require(p.samples >= 1, "samples must be >= 1", p.samples);
  core::require_probability("least_probability", p.least_probability);
  core::require(std::isfinite(p.first_log_odds) && p.first_log_odds >= 0.0, "first_log_odds must be >= 0",
                p.first_log_odds);
  core::require_probability("published_tentative", p.published_tentative);
}

void validate(const HeadingParams& p) {
  core::require(p.steps >= 1, "heading steps must be >= 1", p.steps);
  core::require(p.reach_sigmas > 0.0, "reach_sigmas must be > 0", p.reach_sigmas);
  core::require_share("least_existence", p.least_existence);
}

}  // namespace

void validate(const JointTrackerParams& params) {
  csht::validate(static_cast<const csht::JointEngineParams&>(params));
  validate(params.manoeuvre);
  validate(params.life);
  validate(params.report);
  validate(params.heading);
}

JointTrackerParams for_sensor(const JointTrackerParams& params, const core::SonarParams& sonar) {
  const auto scale = csht::SensorScale::of(sonar);
  JointTrackerParams own = params;
  static_cast<csht::JointEngineParams&>(own) = csht::scaled(params, scale);
  MotionChangeParams& change = own.manoeuvre;
  change.window_s = scale.seconds(params.manoeuvre.window_s, 0.0);
  change.memory_s = scale.seconds(params.manoeuvre.memory_s, 0.0);
  change.position_slack *= scale.length;
  change.velocity_slack *= scale.speed;
  change.acceleration_slack *= scale.acceleration();
  change.turn_slack /= scale.time();
  own.life.twin_distance *= scale.length;
  own.life.twin_speed *= scale.speed;
  own.report.cutoff = std::max(params.report.cutoff, kLeastCutoff * scale.length);
  return own;
}

}  // namespace lookout::tracking
