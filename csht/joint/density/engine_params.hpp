#pragma once

#include <optional>

#include "csht/joint/density/mover.hpp"
#include "csht/joint/density/target_prior.hpp"
#include "csht/likelihood/clutter/clutter_map.hpp"
#include "csht/likelihood/intensity_law.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"
#include "csht/likelihood/sensor_model.hpp"
#include "csht/likelihood/spill_model.hpp"

namespace lookout::csht {

/// The density of one track: weighted trajectories, scored under the exact likelihood of the scans.
struct TrajectoryCloudParams {
  int trajectories = 256;       ///< In a cloud, 32 to 4096.
  double memory_s = 60.0;       ///< Scans older than this are forgotten [s], > 0. docs/joint_estimator.md.
  double refresh_share = 0.25;  ///< A cloud whose effective share falls below is drawn afresh, in (0, 1).
  /// Effective share at which a refresh needs no further round, in (refresh_share, 1).
  double refresh_goal = 0.4;
  int refresh_rounds = 3;       ///< Most rounds of adaptive importance sampling in a refresh, >= 1.
  double proposal_scale = 1.1;  ///< Standard deviations of the proposal over those of the cloud, >= 1.
  double tail_freedom = 6.0;    ///< Degrees of freedom of the proposal's t distribution, > 2.
  int moves = 4;                ///< Steps of a random walk after resampling, >= 1. [Gilks2001] Sec. 3.
  double move_scale = 0.6;      ///< Standard deviations of a step over those of the cloud, > 0.
  /// Effective size of a cloud beyond which a refresh need not improve it, > 0.
  double enough_effective = 50.0;
  double trusted_share = 0.08;    ///< Effective share of a cloud whose evidence is trusted, in (0, 1).
  double tempered_share = 0.1;    ///< Effective share of a cloud whose moments are trusted, in (0, 1). Below,
  double tempering_step = 0.8;    ///< log weights shrink by this factor, time after time, in (0, 1),
  double least_exponent = 0.005;  ///< while their product stays above this one, in (0, 1). [Neal2001] Sec. 2.
  double position_floor = 0.05;   ///< Added to the spread of a proposal, > 0: standard deviations [m],
  double velocity_floor = 0.01;   ///< [m/s] and
  double acceleration_floor = 0.005;  ///< [m/s^2] or
  double turn_floor = 0.0005;         ///< [rad/s].
  double acceleration_prior = 0.2;  ///< Standard deviation of each component of a manoeuvre [m/s^2], > 0: up
                                    ///< to 0.3 m/s^2 are asked for.
  double turn_prior = 0.07;  ///< Standard deviation of a turn rate [rad/s], > 0: up to 6 deg/s are asked for.
};

/// Which beams of a scan a track claims, and which returns may be its own.
struct BeamClaimParams {
  double least_share = 0.02;      ///< Probability of being in a beam that is worth a claim, in (0, 1).
  double detection_sigmas = 4.0;  ///< A detection this near a trajectory may be its own, > 0.
  int past_stride = 8;  ///< Every so many-th trajectory stands for the cloud in claims on past scans, >= 1.
};

/// How new targets are searched: pairs of detections that no track explains, scored into the past.
struct BirthParams {
  double window_s = 20.0;  ///< Longest stretch that a new target is scored over [s], > 0.
  /// Information that is enough to weigh a new target [nats], > 0: twice the logarithm of the number of
  /// trajectories that can be told apart. docs/joint_estimator.md.
  double enough_nats = 30.0;
  /// Evidence after which a target that appears is found [nats], > 0. docs/joint_estimator.md.
  double begin_nats = 11.0;
  double least_nats = 0.05;   ///< A scan is taken to bring this much information at least [nats], > 0.
  int min_lag_scans = 2;      ///< Between the two detections of a pair, >= 1.
  double max_lag_s = 10.0;    ///< Between the two detections of a pair [s], > 0.
  double first_look_s = 6.0;  ///< Stretch over which all pairs are scored before most are dropped [s], > 0.
  int first_look_keep = 192;  ///< Pairs that are scored over the whole window, >= 1.
  /// For the scores of pairs and of refined seeds. Both are single trajectories: one that runs just beside
  /// the edge of a beam would lose all of its detections, so neighbouring beams are mixed, each by its
  /// nearness.
  Tolerance seed_tolerance{1.0, 0.5}, line_tolerance{1.0, 0.5};
  int seeds = 24;     ///< Distinct pairs whose evidence is computed, >= 1.
  int samples = 128;  ///< Trajectories drawn for the first estimate of the evidence, >= 16.
  int rounds = 3;     ///< Rounds of adaptive importance sampling, >= 1.
  /// A seed this far below a tentative track in its first round is dropped [nats], > 0.
  double hopeless = 3.0;
  double doubtful = 1.0;      ///< So is one this far below after its last round [nats], >= 0.
  double explained = 0.5;     ///< A detection explained with this probability begins no pair, in (0, 1].
  int refine_rounds = 2;      ///< Of least squares over memberships, >= 1.
  int tries_per_seed = 3;     ///< Pairs that are refined for each seed that is asked for, >= 1.
  double same_target = 9.0;   ///< Squared Mahalanobis distance (4 degrees of freedom) within which seeds, or
                              ///< a seed and a track, are one target, > 0.
  double track_reach = 30.0;  ///< Tracks farther than this from a seed are not compared with it [m], > 0.
  double better_nats = 2.0;   ///< By which a seed must beat a tentative track to replace it [nats], >= 0.
};

/// When a hypothesis is kept, and how many.
struct HypothesisParams {
  double tentative_log_odds = -6.0;  ///< From which a hypothesis is kept [nats], < 0. docs/joint_tracker.md.
  /// Above which odds are updated by each scan and no more drawn anew [nats], > 0.
  double settled_log_odds = 4.0;
  int max_tracks = 512;   ///< Hypotheses of any status, >= 1; more are not begun.
  int ready_tracks = 64;  ///< Hypotheses that memory is kept for from the start, >= 0.
};

/// How the sensor's figures are learnt from the scans.
struct SensorLearningParams {
  double least_change = 0.01;    ///< Relative change of a sensor figure that is worth a rewrite, > 0.
  int target_samples = 32;       ///< Trajectories that stand for a target, >= 1.
  double least_existence = 0.5;  ///< Of a target whose beams are its own, in [0, 1].
  /// The speed from which it teaches [max speed], >= 0: what stands is heard more often than what moves, and
  /// would teach too few misses.
  double least_speed = 0.1;
  MoverParams mover;  ///< A slower one that surely moves teaches, too.
};

/// How the density of false returns is learnt, and what tracks have to do with it.
struct ClutterLearningParams {
  SpillParams spill;             ///< How echoes heard in several beams are recognised.
  ClutterMapParams map;          ///< Where false returns are counted.
  IntensityLawParams intensity;  ///< What the intensity of a return tells.
  int judge_every = 4;  ///< Scans after which the past is judged anew, and a new scan priced anew, >= 1.
  double least_change = 0.05;  ///< Relative change of a return's share that is worth it, > 0.
  double sure_existence =
      0.9;                 ///< A track is no clutter that surely moves, has so much existence, in (0, 1),
  double sure_age = 10.0;  ///< lives for so long [range sigma / max speed], >= 0,
  double sure_sigma = 1.0 / 6.0;  ///< and whose velocity is known so well [max speed], > 0.
  MoverParams mover;              ///< When it surely moves.
};

/// The joint engine: the sensor's likelihood, the prior, and how densities are drawn, claimed and begun.
struct JointEngineParams {
  SensorModelParams sensor;  ///< How a scan is read as a likelihood.
  Tolerance tolerance;      ///< By which a trajectory may miss a return, and how soft the edges of beams are.
  TargetPriorParams prior;  ///< How many targets are expected, where and how fast.
  TrajectoryCloudParams cloud;    ///< How the density of one target is drawn and kept.
  BeamClaimParams claims;         ///< What a track takes of a scan.
  BirthParams birth;              ///< How new targets are searched.
  HypothesisParams hypotheses;    ///< Which hypotheses are kept.
  SensorLearningParams learning;  ///< How P_F, P_M and sigma are learnt.
  ClutterLearningParams clutter;  ///< How the density of false returns is learnt.
  /// Scans kept, >= 1; absent: as many as `cloud.memory_s` and `birth.window_s` ask for.
  std::optional<int> scans_kept;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const JointEngineParams& params);
/// @throws std::invalid_argument showing the value that is out of range.
void validate(const TrajectoryCloudParams& params);
/// @throws std::invalid_argument showing the value that is out of range.
void validate(const BeamClaimParams& params);
/// @throws std::invalid_argument showing the value that is out of range.
void validate(const BirthParams& params);

}  // namespace lookout::csht
