#pragma once

#include "csht/joint/density/engine_params.hpp"
#include "csht/likelihood/sensor_model.hpp"

namespace lookout::tracking {

/// Targets that turn or change speed.
struct MotionChangeParams {
  double window_s = 8.0;       ///< Stretch that a curved trajectory holds for [s], in (0, 30]. At 6 deg/s and
                               ///< 3 m/s a constant acceleration is then off by at most 0.4 m.
  double prior = 0.001;        ///< That a window begins a manoeuvre, in (0, 1).
  double curved_share = 0.05;  ///< Targets that turn from their first scan on, and targets that accelerate,
                               ///< per one that goes straight, in (0, 1).
  double trigger_share = 0.75;  ///< A line is doubted when it brings less than this share of its evidence.
  int sudden_scans = 4;         ///< ... or when over this many scans, >= 1,
  double sudden_nats = 6.0;     ///< it falls this much short of what was to be expected, > 0.
  int least_scans = 7;     ///< A track younger than this is not judged, >= 1; a curve spans as many at least.
  double memory_s = 16.0;  ///< How long an acceleration is remembered [s], >= window_s.
  int rounds = 10;         ///< Of adaptive importance sampling, >= 1: the guess may be some metres off.
  int present_rounds = 3;  ///< ... of the motion that a young track has, >= 1: the guess is its own density.
  double position_slack = 2.0;       ///< How far a manoeuvre may have led off the line [m], > 0,
  double velocity_slack = 0.5;       ///< [m/s], > 0, and
  double acceleration_slack = 0.15;  ///< [m/s^2], > 0, one standard deviation each.
  double turn_slack = 0.07;          ///< Of a turn rate [rad/s], > 0.
  double straighten_nats = 2.5;      ///< Evidence for the line that ends a bend or a young turn, >= 0, and
  double bend_nats = 1.0;            ///< for the bend that ends a young turn, >= 0.
  double turn_nats = 1.0;            ///< By which a turn must beat a bend where a line ends, >= 0.
  int young_windows = 2;     ///< A whole life or a turn of at most so many windows may be a wrong one, >= 0.
  double redraw_nats = 1.0;  ///< Evidence for another whole life that is worth the change, > 0.
  double hopeless_nats = 4.0;   ///< A bend that falls this much short is not worth a look at the rest, >= 0.
  double rough_nats = 8.0;      ///< Evidence that is believed of a cloud below `trusted_share`.
  double trusted_share = 0.08;  ///< Effective share of a cloud whose evidence is trusted, in (0, 1).
  double life_log_odds = -3.0;  ///< Existence that a track must have for its life to be judged, and
  double least_log_odds = 2.0;  ///< must have reached for its latest scans to be.
};

/// When tracks begin, are confirmed and end.
struct LifeParams {
  double end_log_odds = -3.0;  ///< Existence below which a track that was confirmed ends.
  double mean_life_s = 500.0;  ///< Mean time after which a target vanishes in view [s], > 0.
  double coast_s = 10.0;       ///< How long a track is published since it was last in view [s], >= 0.
  double return_s = 30.0;      ///< How long it is kept, in case it comes back [s], >= 0; no less than
                               ///< the coast. At 6 deg/s a target has turned round in that time.
  double twin_distance = 4.0;  ///< Two tracks nearer than this [m] ...
  double twin_speed = 0.5;     ///< ... and in velocity [m/s] are one target's.
  double in_view_share = 0.5;  ///< Visible share below which a track counts as out of view, in (0, 1).
};

/// What is reported.
struct ReportParams {
  bool report_all = false;  ///< Every track above `min_existence` rather than the set of least expected OSPA.
  double min_existence = 0.5;       ///< For report_all, and of tracks that coast, in [0, 1].
  double cutoff = 20.0;             ///< Of the OSPA that is minimised [m], > 0.
  int samples = 128;                ///< Target sets drawn to estimate it, >= 1.
  double least_probability = 0.02;  ///< From which a track is weighed for the report, in [0, 1].
  /// Of tracks that are reported for the first time, one in 1 + e^this may be a false one [nats], >= 0: odds
  /// that creep over a threshold stand near it then, odds that leap with every echo stand far beyond, and may
  /// have a lower one (`log_overshoot`), 0 at least.
  double first_log_odds = 1.75;
  double published_tentative = 0.05;  ///< Existence from which a tentative track is published, in [0, 1].
};

/// The error of a heading that the targets of a scan share.
struct HeadingParams {
  int steps = 6;                 ///< Of the grid to either side of the stated heading, >= 1.
  double reach_sigmas = 2.5;     ///< How far the grid reaches, in standard deviations of a heading, > 0.
  double least_existence = 0.5;  ///< Of tracks that tell, in (0, 1].
};

/// The joint tracker: the engine that it shares with the joint estimator, and what only tracks have.
struct JointTrackerParams : csht::JointEngineParams {
  MotionChangeParams manoeuvre;
  LifeParams life;
  ReportParams report;
  HeadingParams heading;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const JointTrackerParams& params);

}  // namespace lookout::tracking
