#include "csht/joint/density/engine_params.hpp"

#include "core/parameter_check.hpp"

namespace lookout::csht {

void validate(const TrajectoryCloudParams& p) {
  core::require(p.trajectories >= 32 && p.trajectories <= 4096, "trajectories must be in [32, 4096]",
                p.trajectories);
  core::require(p.memory_s > 0.0, "memory_s must be > 0", p.memory_s);
  core::require(p.refresh_share > 0.0 && p.refresh_share < 1.0, "refresh_share must be in (0, 1)",
                p.refresh_share);
  core::require(p.refresh_goal > p.refresh_share && p.refresh_goal < 1.0,
                "refresh_goal must be in (refresh_share, 1)", p.refresh_goal);
  core::require(p.refresh_rounds >= 1, "refresh_rounds must be >= 1", p.refresh_rounds);
  core::require(p.proposal_scale >= 1.0, "proposal_scale must be >= 1", p.proposal_scale);
  core::require(p.tail_freedom > 2.0, "tail_freedom must be > 2", p.tail_freedom);
  core::require(p.moves >= 1, "moves must be >= 1", p.moves);
  core::require(p.move_scale > 0.0, "move_scale must be > 0", p.move_scale);
  core::require(p.enough_effective > 0.0, "enough_effective must be > 0", p.enough_effective);
  core::require(p.trusted_share > 0.0 && p.trusted_share < 1.0, "trusted_share must be in (0, 1)",
                p.trusted_share);
  core::require(p.tempered_share > 0.0 && p.tempered_share < 1.0, "tempered_share must be in (0, 1)",
                p.tempered_share);
  core::require(p.tempering_step > 0.0 && p.tempering_step < 1.0, "tempering_step must be in (0, 1)",
                p.tempering_step);
  core::require(p.least_exponent > 0.0 && p.least_exponent < 1.0, "least_exponent must be in (0, 1)",
                p.least_exponent);
  core::require(p.position_floor > 0.0, "position_floor must be > 0", p.position_floor);
  core::require(p.velocity_floor > 0.0, "velocity_floor must be > 0", p.velocity_floor);
  core::require(p.acceleration_floor > 0.0, "acceleration_floor must be > 0", p.acceleration_floor);
  core::require(p.turn_floor > 0.0, "turn_floor must be > 0", p.turn_floor);
  core::require(p.acceleration_prior > 0.0, "acceleration_prior must be > 0", p.acceleration_prior);
  core::require(p.turn_prior > 0.0, "turn_prior must be > 0", p.turn_prior);
}

void validate(const BeamClaimParams& p) {
  core::require(p.least_share > 0.0 && p.least_share < 1.0, "least_share must be in (0, 1)", p.least_share);
  core::require(p.detection_sigmas > 0.0, "detection_sigmas must be > 0", p.detection_sigmas);
  core::require(p.past_stride >= 1, "past_stride must be >= 1", p.past_stride);
}

void validate(const BirthParams& p) {
  core::require(p.window_s > 0.0, "window_s must be > 0", p.window_s);
  core::require(p.min_lag_scans >= 1, "min_lag_scans must be >= 1", p.min_lag_scans);
  core::require(p.max_lag_s > 0.0, "max_lag_s must be > 0", p.max_lag_s);
  core::require(p.first_look_s > 0.0, "first_look_s must be > 0", p.first_look_s);
  core::require(p.first_look_keep >= 1, "first_look_keep must be >= 1", p.first_look_keep);
  core::require(p.seeds >= 1, "seeds must be >= 1", p.seeds);
  core::require(p.samples >= 16, "samples must be >= 16", p.samples);
  core::require(p.rounds >= 1, "rounds must be >= 1", p.rounds);
  core::require(p.hopeless > 0.0, "hopeless must be > 0", p.hopeless);
  core::require(p.enough_nats > 0.0, "enough_nats must be > 0", p.enough_nats);
  core::require(p.begin_nats > 0.0, "begin_nats must be > 0", p.begin_nats);
  core::require(p.least_nats > 0.0 && p.least_nats < p.begin_nats, "least_nats must be in (0, begin_nats)",
                p.least_nats);
  core::require(p.doubtful >= 0.0, "doubtful must be >= 0", p.doubtful);
  core::require(p.explained > 0.0 && p.explained <= 1.0, "explained must be in (0, 1]", p.explained);
  core::require(p.refine_rounds >= 1, "refine_rounds must be >= 1", p.refine_rounds);
  core::require(p.tries_per_seed >= 1, "tries_per_seed must be >= 1", p.tries_per_seed);
  core::require(p.same_target > 0.0, "same_target must be > 0", p.same_target);
  core::require(p.track_reach > 0.0, "track_reach must be > 0", p.track_reach);
  core::require(p.better_nats >= 0.0, "better_nats must be >= 0", p.better_nats);
}

namespace {

void validate(const HypothesisParams& p) {
  core::require(p.tentative_log_odds < 0.0, "tentative_log_odds must be < 0", p.tentative_log_odds);
  core::require(p.settled_log_odds > 0.0, "settled_log_odds must be > 0", p.settled_log_odds);
  core::require(p.max_tracks >= 1, "max_tracks must be >= 1", p.max_tracks);
  core::require(p.ready_tracks >= 0, "ready_tracks must be >= 0", p.ready_tracks);
}

void validate(const SensorLearningParams& p) {
  core::require(p.least_change > 0.0, "least_change must be > 0", p.least_change);
  core::require(p.target_samples >= 1, "target_samples must be >= 1", p.target_samples);
  core::require(p.least_existence >= 0.0 && p.least_existence <= 1.0, "least_existence must be in [0, 1]",
                p.least_existence);
  core::require(p.least_speed >= 0.0, "least_speed must be >= 0", p.least_speed);
  validate(p.mover);
}

void validate(const ClutterLearningParams& p) {
  validate(p.map);
  validate(p.spill);
  validate(p.intensity);
  core::require(p.judge_every >= 1, "judge_every must be >= 1", p.judge_every);
  core::require(p.least_change > 0.0, "least_change must be > 0", p.least_change);
  core::require(p.sure_existence > 0.0 && p.sure_existence < 1.0, "sure_existence must be in (0, 1)",
                p.sure_existence);
  core::require(p.sure_sigma > 0.0, "sure_sigma must be > 0", p.sure_sigma);
  validate(p.mover);
}

}  // namespace

void validate(const JointEngineParams& params) {
  validate(params.sensor);
  validate(params.prior);
  validate(params.cloud);
  validate(params.claims);
  validate(params.birth);
  validate(params.hypotheses);
  validate(params.learning);
  validate(params.clutter);
  if (params.scans_kept)
    core::require(*params.scans_kept >= 1, "scans_kept must be >= 1", *params.scans_kept);
}

}  // namespace lookout::csht
