#pragma once

#include "csht/joint/density/engine_params.hpp"
#include "csht/likelihood/sensor_model.hpp"
#include "tracking/joint/standing.hpp"

namespace lookout::tracking {

/// When a track's motion is taken for another one. docs/joint_tracker.md.
struct MotionChangeParams {
  double window_s = 8.0;       ///< Scans that a change of motion is judged by [s], in (0, 30]. Over 8 s, at
                               ///< 6 deg/s and 3 m/s, acceleration is off a turn by 0.4 m at most.
  double prior = 0.001;        ///< Probability that a manoeuvre begins in a window, in (0, 1).
  double curved_share = 0.05;  ///< Targets in a constant turn from their first scan on, and targets at
                               ///< constant acceleration, for each one at constant velocity, in (0, 1).
  /// A motion is doubted where it brings less than this share of the evidence expected in a window,
  double trigger_share = 0.75;
  int sudden_scans = 4;      ///< or when over so many scans, >= 1,
  double sudden_nats = 6.0;  ///< it is this much below what was expected [nats], > 0.
  int least_scans = 7;       ///< A younger track is not judged, and a window has as many at least, >= 1.
  double memory_s = 16.0;  ///< Scans older than this do not count for constant acceleration [s], >= window_s.
  int rounds = 10;  ///< Of importance sampling for another motion, >= 1: its guess may be off by metres.
  int present_rounds = 3;  ///< Likewise for the present motion of a young track, >= 1, which has its density.
  double position_slack = 2.0;       ///< How far a manoeuvre may have led off the old trajectory, > 0: [m],
  double velocity_slack = 0.5;       ///< [m/s],
  double acceleration_slack = 0.15;  ///< [m/s^2] and
  double turn_slack = 0.07;          ///< [rad/s], one standard deviation each.
  /// Evidence for constant velocity that ends constant acceleration or a young constant turn [nats], >= 0.
  double constant_velocity_nats = 2.5;
  /// Evidence for constant acceleration that ends a young constant turn [nats], >= 0.
  double constant_acceleration_nats = 1.0;
  /// By which constant turn must beat constant acceleration where another motion ends [nats], >= 0.
  double constant_turn_nats = 1.0;
  int young_windows = 2;  ///< A track or a constant turn of at most so many windows is young, >= 0.
  /// Evidence for another motion over a whole life that is worth the change [nats], > 0.
  double redraw_nats = 1.0;
  double hopeless_nats = 4.0;   ///< Where acceleration is this far below what is needed, no other motion is
                                ///< tried [nats], >= 0.
  double rough_nats = 8.0;      ///< Taken off the evidence of a cloud below `trusted_share` [nats].
  double trusted_share = 0.08;  ///< Effective share of a cloud whose evidence is trusted, in (0, 1).
  /// Log odds that a young track must have for the motion of its whole life to be judged [nats].
  double life_log_odds = -3.0;
  /// Log odds that an older track must have had once for its motion over the latest scans to be judged
  /// [nats].
  double least_log_odds = 2.0;
};

/// How long tracks live.
struct LifeParams {
  double end_log_odds = -3.0;  ///< Below which a track that was confirmed is deleted [nats], < 0.
  double mean_life_s = 500.0;  ///< Mean time after which a target vanishes in view [s], > 0.
  double coast_s = 10.0;       ///< How long a track is published since it was last in view [s], >= 0.
  double return_s = 30.0;      ///< How long it is kept, in case it comes back [s], >= 0; no less than
                               ///< the coast. At 6 deg/s a target has turned round in that time.
  double twin_distance = 4.0;  ///< Two tracks no farther apart than this [m], >= 0,
  double twin_speed = 0.5;     ///< and in velocity [m/s], >= 0, are twins.
  /// Of a sensor without beams, the least probability that a target which it missed is missed by the next
  /// scan, too, in (0, 1): ships are hidden or end-on for a while, so that misses come in runs.
  double missed_again = 0.5;
  /// Probability of being in view below which a track is out of view, in (0, 1).
  double in_view_share = 0.5;
};

/// Which tracks are reported, that is confirmed, and which are published.
struct ReportParams {
  bool report_all = false;  ///< Every track above `min_existence` rather than the set of least expected OSPA.
  double min_existence = 0.5;  ///< Least existence, for report_all and of tracks that coast, in [0, 1].
  double cutoff = 20.0;        ///< Of the OSPA that is minimised [m], > 0; 2.5 errors of position at least.
  int samples = 128;           ///< Target sets drawn to estimate it, >= 1.
  double least_probability = 0.02;  ///< From which a track is weighed for the report, in [0, 1].
  /// Of the tracks that are reported for the first time, one in 1 + e^this may be false [nats], >= 0. Log
  /// odds that grow slowly stand just above a threshold when they cross it, and the threshold is this; where
  /// each detection makes them leap far beyond, it is lower by the mean overshoot (`log_overshoot`), but 0 at
  /// least.
  double first_log_odds = 1.75;
  StandingParams standing;            ///< What stands still.
  double published_tentative = 0.05;  ///< Existence from which a tentative track is published, in [0, 1].
};

/// How the error of a scan's heading is found.
struct HeadingParams {
  int steps = 6;                 ///< Of the grid, to either side of the stated heading, >= 1.
  double reach_sigmas = 2.5;     ///< How far the grid reaches, in standard deviations of a heading, > 0.
  double least_existence = 0.5;  ///< Of a track that is used, in (0, 1].
};

/// The joint tracker: the engine that it shares with the joint estimator, and what only tracks have.
struct JointTrackerParams : csht::JointEngineParams {
  MotionChangeParams manoeuvre;  ///< When a track's motion changes.
  LifeParams life;               ///< When tracks coast and are deleted.
  ReportParams report;           ///< Which tracks are confirmed and published.
  HeadingParams heading;         ///< How errors of the heading are found.
};

/// The parameters for a sensor: lengths, speeds and times follow its errors, scans and targets. They are
/// stated for the sonar of [Yan2018] Table 1; see csht::SensorScale.
JointTrackerParams for_sensor(const JointTrackerParams& params, const core::SonarParams& sonar);

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const JointTrackerParams& params);

}  // namespace lookout::tracking
