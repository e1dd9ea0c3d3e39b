#pragma once

#include <optional>

#include "csht/joint/density/target_prior.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::csht {

/// The density of one track: weighted trajectories, scored under the exact likelihood of the scans.
struct TrajectoryCloudParams {
  int trajectories = 256;  ///< In a cloud, 32 to 4096.
  double memory_s = 60.0;  ///< Scans older than this are forgotten [s], > 0. docs/joint_estimator.md.
  double refresh_share =
      0.25;                   ///< Drawn afresh when the effective share of the cloud falls below, in (0, 1).
  double refresh_goal = 0.4;  ///< Effective share at which a refresh is content, in (refresh_share, 1).
  int refresh_rounds = 3;     ///< Most rounds of adaptive importance sampling a refresh, >= 1.
  double proposal_scale = 1.1;     ///< Standard deviations of the proposal over those of the cloud, >= 1.
  double tail_freedom = 6.0;       ///< Degrees of freedom of the proposal's t distribution, > 2.
  int moves = 4;                   ///< Steps of a random walk after resampling, >= 1.
  double move_scale = 0.6;         ///< Their standard deviations over those of the cloud, > 0.
  double enough_effective = 50.0;  ///< Trajectories that carry a cloud that is as good as it gets, > 0.
  double trusted_share = 0.08;     ///< Effective share of a cloud whose evidence is trusted, in (0, 1).
  double tempered_share = 0.1;    ///< Effective share of a cloud whose moments are trusted, in (0, 1); below,
  double tempering_step = 0.8;    ///< its log weights shrink by this factor at a time, in (0, 1),
  double least_exponent = 0.005;  ///< down to this exponent, in (0, 1).
  double position_floor = 0.05;   ///< Least standard deviations that are proposed, > 0: [m],
  double velocity_floor = 0.01;   ///< [m/s] and
  double acceleration_floor = 0.005;  ///< [m/s^2] or
  double turn_floor = 0.0005;         ///< [rad/s].
  double acceleration_prior = 0.2;  ///< Standard deviation of each component of a manoeuvre [m/s^2], > 0: up
                                    ///< to 0.3 m/s^2 are asked for.
  double turn_prior = 0.07;  ///< Standard deviation of a turn rate [rad/s], > 0: up to 6 deg/s are asked for.
};

/// How a track sees itself in a scan, and what it claims there.
struct BeamClaimParams {
  double least_share = 0.02;  ///< Probability of being in a beam that is worth a claim, in (0, 1).
  double echo_sigmas = 4.0;   ///< An echo this near a trajectory may be its own, > 0.
  int past_stride = 8;  ///< Every so many-th trajectory stands for the cloud in claims on past scans, >= 1.
};

/// Births: pairs of echoes that no track explains, scored backwards.
struct BirthParams {
  double window_s = 20.0;  ///< Longest stretch that a new target is scored over [s], > 0.
  double enough_nats =
      30.0;  ///< Information that is enough to weigh a new target [nats], > 0: twice what the
             ///< number of trajectories that can be told apart asks for. docs/joint_estimator.md.
  double begin_nats =
      11.0;  ///< Evidence after which a target that appears is found, > 0. docs/joint_estimator.md.
  double least_nats = 0.05;   ///< Least information of a scan that is reckoned with [nats], > 0.
  int min_lag_scans = 2;      ///< Between the two echoes of a pair, >= 1.
  double max_lag_s = 10.0;    ///< Between the two echoes of a pair [s], > 0.
  double first_look_s = 6.0;  ///< Stretch over which all pairs are scored before most are dropped [s], > 0.
  int first_look_keep = 192;  ///< Pairs that are scored over the whole window, >= 1.
  /// Of a pair and of a refined line: a single line is scored fairly only when neighbouring beams are mixed
  /// in proportion to nearness, and a pair has the errors of its own two detections besides.
  Tolerance seed_tolerance{1.0, 0.5}, line_tolerance{1.0, 0.5};
  int seeds = 24;     ///< Distinct pairs whose evidence is computed, >= 1.
  int samples = 128;  ///< Trajectories drawn for the first estimate of the evidence, >= 16.
  int rounds = 3;     ///< Rounds of adaptive importance sampling, >= 1.
  double hopeless =
      3.0;  ///< A seed this many nats short of a tentative track in its first round is dropped, > 0.
  double doubtful = 1.0;      ///< ... and this many short after its last round, >= 0.
  double explained = 0.5;     ///< An echo explained with this probability begins no pair, in (0, 1].
  int refine_rounds = 2;      ///< Of least squares over memberships, >= 1.
  int tries_per_seed = 3;     ///< Pairs that are refined for each seed that is asked for, >= 1.
  double same_target = 9.0;   ///< Squared Mahalanobis distance (4 degrees of freedom) within which seeds, or
                              ///< a seed and a track, are one target, > 0.
  double track_reach = 30.0;  ///< Tracks farther than this from a seed are not compared with it [m], > 0.
  double better_nats = 2.0;   ///< By which a seed must beat a tentative track to replace it, >= 0.
};

/// When a hypothesis is kept, and how many.
struct HypothesisParams {
  double tentative_log_odds = -6.0;  ///< Existence from which a hypothesis is kept. docs/joint_tracker.md.
  double settled_log_odds = 4.0;  ///< Existence above which odds are only updated, not estimated again, > 0.
  int max_tracks = 512;           ///< Hypotheses of any status, >= 1; more are not begun.
  int ready_tracks = 64;          ///< Hypotheses that memory is kept for from the start, >= 0.
};

/// What sure targets teach of the sensor.
struct SensorLearningParams {
  double least_change = 0.01;    ///< Relative change of a sensor figure that is worth a rewrite, > 0.
  int target_samples = 32;       ///< Trajectories that stand for a target, >= 1.
  double least_existence = 0.5;  ///< Of a target whose beams are its own, in [0, 1].
};

/// The joint engine: the sensor's likelihood, the prior, and how densities are drawn, claimed and begun.
struct JointEngineParams {
  SensorModelParams sensor;
  Tolerance tolerance;  ///< Of hypotheses and of evidence; see there.
  TargetPriorParams prior;
  TrajectoryCloudParams cloud;
  BeamClaimParams observer;
  BirthParams birth;
  HypothesisParams hypotheses;
  SensorLearningParams learning;
  /// Scans kept, >= 1; absent: as many as `cloud.memory_s` and `birth.window_s` ask for.
  std::optional<int> scans_kept;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const JointEngineParams& params);
void validate(const TrajectoryCloudParams& params);
void validate(const BeamClaimParams& params);
void validate(const BirthParams& params);

}  // namespace lookout::csht
