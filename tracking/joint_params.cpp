#include <stdexcept>
#include <string>

#include "tracking/joint_params.hpp"

#include <cmath>
namespace lookout::tracking {
namespace {

void require(bool holds, const char* what, double value) {
  if (!holds) throw std::invalid_argument(std::string(what) + ", got " + std::to_string(value));
}

void validate(const JointCloudParams& p) {
  require(p.trajectories >= 32 && p.trajectories <= 4096, "trajectories must be in [32, 4096]",
          p.trajectories);
  require(p.memory_s > 0.0, "memory_s must be > 0", p.memory_s);
  require(p.refresh_share > 0.0 && p.refresh_share < 1.0, "refresh_share must be in (0, 1)", p.refresh_share);
  require(p.refresh_goal > p.refresh_share && p.refresh_goal < 1.0,
          "refresh_goal must be in (refresh_share, 1)", p.refresh_goal);
  require(p.refresh_rounds >= 1, "refresh_rounds must be >= 1", p.refresh_rounds);
  require(p.proposal_scale >= 1.0, "proposal_scale must be >= 1", p.proposal_scale);
  require(p.tail_freedom > 2.0, "tail_freedom must be > 2", p.tail_freedom);
  require(p.moves >= 1, "moves must be >= 1", p.moves);
  require(p.move_scale > 0.0, "move_scale must be > 0", p.move_scale);
  require(p.enough_effective > 0.0, "enough_effective must be > 0", p.enough_effective);
  require(p.trusted_share > 0.0 && p.trusted_share < 1.0, "trusted_share must be in (0, 1)", p.trusted_share);
  require(p.tempered_share > 0.0 && p.tempered_share < 1.0, "tempered_share must be in (0, 1)",
          p.tempered_share);
  require(p.tempering_step > 0.0 && p.tempering_step < 1.0, "tempering_step must be in (0, 1)",
          p.tempering_step);
  require(p.least_exponent > 0.0 && p.least_exponent < 1.0, "least_exponent must be in (0, 1)",
          p.least_exponent);
  require(p.position_floor > 0.0, "position_floor must be > 0", p.position_floor);
  require(p.velocity_floor > 0.0, "velocity_floor must be > 0", p.velocity_floor);
  require(p.acceleration_floor > 0.0, "acceleration_floor must be > 0", p.acceleration_floor);
  require(p.turn_floor > 0.0, "turn_floor must be > 0", p.turn_floor);
  require(p.acceleration_prior > 0.0, "acceleration_prior must be > 0", p.acceleration_prior);
  require(p.turn_prior > 0.0, "turn_prior must be > 0", p.turn_prior);
}

void validate(const JointObserverParams& p) {
  require(p.least_share > 0.0 && p.least_share < 1.0, "least_share must be in (0, 1)", p.least_share);
  require(p.echo_sigmas > 0.0, "echo_sigmas must be > 0", p.echo_sigmas);
  require(p.past_stride >= 1, "past_stride must be >= 1", p.past_stride);
}

void validate(const JointBirthParams& p) {
  require(p.window_s > 0.0, "window_s must be > 0", p.window_s);
  require(p.min_lag_scans >= 1, "min_lag_scans must be >= 1", p.min_lag_scans);
  require(p.max_lag_s > 0.0, "max_lag_s must be > 0", p.max_lag_s);
  require(p.first_look_s > 0.0, "first_look_s must be > 0", p.first_look_s);
  require(p.first_look_keep >= 1, "first_look_keep must be >= 1", p.first_look_keep);
  require(p.seeds >= 1, "seeds must be >= 1", p.seeds);
  require(p.samples >= 16, "samples must be >= 16", p.samples);
  require(p.rounds >= 1, "rounds must be >= 1", p.rounds);
  require(p.hopeless > 0.0, "hopeless must be > 0", p.hopeless);
  require(p.enough_nats > 0.0, "enough_nats must be > 0", p.enough_nats);
  require(p.begin_nats > 0.0, "begin_nats must be > 0", p.begin_nats);
  require(p.least_nats > 0.0 && p.least_nats < p.begin_nats, "least_nats must be in (0, begin_nats)",
          p.least_nats);
  require(p.doubtful >= 0.0, "doubtful must be >= 0", p.doubtful);
  require(p.explained > 0.0 && p.explained <= 1.0, "explained must be in (0, 1]", p.explained);
  require(p.refine_rounds >= 1, "refine_rounds must be >= 1", p.refine_rounds);
  require(p.tries_per_seed >= 1, "tries_per_seed must be >= 1", p.tries_per_seed);
  require(p.same_target > 0.0, "same_target must be > 0", p.same_target);
  require(p.track_reach > 0.0, "track_reach must be > 0", p.track_reach);
  require(p.better_nats >= 0.0, "better_nats must be >= 0", p.better_nats);
}

void validate(const JointManoeuvreParams& p) {
  require(p.window_s > 0.0 && p.window_s <= 30.0, "manoeuvre window_s must be in (0, 30]", p.window_s);
  require(p.prior > 0.0 && p.prior < 1.0, "manoeuvre prior must be in (0, 1)", p.prior);
  require(p.curved_share > 0.0 && p.curved_share < 1.0, "curved_share must be in (0, 1)", p.curved_share);
  require(p.least_scans >= 1, "least_scans must be >= 1", p.least_scans);
  require(p.memory_s >= p.window_s, "manoeuvre memory_s must be >= window_s", p.memory_s);
  require(p.rounds >= 1, "manoeuvre rounds must be >= 1", p.rounds);
  require(p.present_rounds >= 1, "present_rounds must be >= 1", p.present_rounds);
  require(p.position_slack > 0.0, "position_slack must be > 0", p.position_slack);
  require(p.velocity_slack > 0.0, "velocity_slack must be > 0", p.velocity_slack);
  require(p.acceleration_slack > 0.0, "acceleration_slack must be > 0", p.acceleration_slack);
  require(p.turn_slack > 0.0, "turn_slack must be > 0", p.turn_slack);
  require(p.straighten_nats >= 0.0, "straighten_nats must be >= 0", p.straighten_nats);
  require(p.redraw_nats > 0.0, "redraw_nats must be > 0", p.redraw_nats);
  require(p.young_windows >= 0, "young_windows must be >= 0", p.young_windows);
  require(p.sudden_scans >= 1, "sudden_scans must be >= 1", p.sudden_scans);
  require(p.hopeless_nats >= 0.0, "hopeless_nats must be >= 0", p.hopeless_nats);
  require(p.turn_nats >= 0.0, "turn_nats must be >= 0", p.turn_nats);
  require(p.bend_nats >= 0.0, "bend_nats must be >= 0", p.bend_nats);
  require(p.trusted_share > 0.0 && p.trusted_share < 1.0, "trusted_share must be in (0, 1)", p.trusted_share);
}

void validate(const JointLifeParams& p) {
  require(p.tentative_log_odds < 0.0, "tentative_log_odds must be < 0", p.tentative_log_odds);
  require(p.end_log_odds < 0.0, "end_log_odds must be < 0", p.end_log_odds);
  require(p.mean_life_s > 0.0, "mean_life_s must be > 0", p.mean_life_s);
  require(p.coast_s >= 0.0, "coast_s must be >= 0", p.coast_s);
  require(p.return_s >= 0.0, "return_s must be >= 0", p.return_s);
  require(p.max_tracks >= 1, "max_tracks must be >= 1", p.max_tracks);
  require(p.ready_tracks >= 0, "ready_tracks must be >= 0", p.ready_tracks);
  require(p.twin_distance >= 0.0, "twin_distance must be >= 0", p.twin_distance);
  require(p.twin_speed >= 0.0, "twin_speed must be >= 0", p.twin_speed);
  require(p.in_view_share > 0.0 && p.in_view_share < 1.0, "in_view_share must be in (0, 1)", p.in_view_share);
  require(p.settled_log_odds > 0.0, "settled_log_odds must be > 0", p.settled_log_odds);
}

void validate(const JointReportParams& p) {
  require(p.min_existence >= 0.0 && p.min_existence <= 1.0, "min_existence must be in [0, 1]",
          p.min_existence);
  require(p.cutoff > 0.0, "cutoff must be > 0", p.cutoff);
  require(p.samples >= 1, "samples must be >= 1", p.samples);
  require(p.least_probability >= 0.0 && p.least_probability <= 1.0, "least_probability must be in [0, 1]",
          p.least_probability);
  require(std::isfinite(p.first_log_odds) && p.first_log_odds >= 0.0, "first_log_odds must be >= 0",
          p.first_log_odds);
  require(p.published_tentative >= 0.0 && p.published_tentative <= 1.0,
          "published_tentative must be in [0, 1]", p.published_tentative);
}

void validate(const JointLearningParams& p) {
  require(p.least_change > 0.0, "least_change must be > 0", p.least_change);
  require(p.target_samples >= 1, "target_samples must be >= 1", p.target_samples);
}

void validate(const JointHeadingParams& p) {
  require(p.steps >= 1, "heading steps must be >= 1", p.steps);
  require(p.reach_sigmas > 0.0, "reach_sigmas must be > 0", p.reach_sigmas);
  require(p.least_existence > 0.0 && p.least_existence <= 1.0, "least_existence must be in (0, 1]",
          p.least_existence);
}

}  // namespace

void validate(const JointTrackerParams& params) {
  csht::validate(params.sensor);
  validate(params.prior);
  validate(params.cloud);
  validate(params.observer);
  validate(params.birth);
  validate(params.manoeuvre);
  validate(params.life);
  validate(params.report);
  validate(params.learning);
  validate(params.heading);
}

}  // namespace lookout::tracking
