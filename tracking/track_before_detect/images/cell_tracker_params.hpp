#pragma once

#include "tracking/track_before_detect/images/cell_measurement.hpp"
#include "tracking/track_before_detect/images/course_mixture.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"

namespace lookout::tracking {

/// How a target moves.
struct CellMotionParams {
  double steady_density = 0.0004;  ///< White acceleration on a steady course [unit^2 / s^3], > 0.
  double agile_density = 0.05;     ///< Where the innovations say that it turns [unit^2 / s^3], > 0.
  double usual_share = 0.01;  ///< Of the filter's density, what the published error allows for, in (0, 1].
  double start_speed_sigma = 1.0;  ///< Of each velocity component of a new track [unit/s], > 0.
  double max_speed = 4.0;          ///< Faster tracks are deleted [unit/s], > 0.
};

/// How a track comes to exist and ends.
struct CellExistenceParams {
  double birth_expectation = 15.0;  ///< Blocks a frame and scale that start tracks without a target, > 0.
  double births_per_frame = 3.0;  ///< Prior: targets expected to appear in a frame, > 0; at the first, to be.
  double birth_rate = 6.0;        ///< And in a second, where that is fewer [1/s], > 0.
  double rank_exponent = 0.15;    ///< a: ranks of targets have density a p^(a - 1), in (0, 1).
  double least_probability = 1e-6;   ///< A block less probable than this says no more, in (0, 1).
  double lifetime = 25.0;            ///< Mean time that a target lasts [s], > 0.
  double confirm_existence = 0.995;  ///< In (0, 1).
  double most_existence = 0.99999;   ///< No track is surer, in (0, 1).
  int min_age = 1;                   ///< Frames after its first before a track is confirmed, >= 0.
  double delete_confirmed = 0.02;    ///< Existence below which a confirmed track ends.
  double delete_tentative = 1e-5;    ///< And a tentative one.
  double merge_distance = 1.5;       ///< Tracks nearer than this are one [signatures], >= 0.
  double birth_distance = 5.0;       ///< Peaks nearer to a track than this start none [signatures], >= 0.
  double sidelobe_ratio = 0.3;       ///< Peaks in a track's columns below this share of it start none, >= 0.
  double coast = 10.0;               ///< How long a confirmed track outside the image is kept [s], >= 0.
  double leave_out_existence = 0.9;  ///< Above it (and once confirmed) a target's blocks are no background.
  int max_births = 64;               ///< Of a frame, >= 1.
  int max_tracks = 300;              ///< >= 1.
};

/// What stands over ground is background.
struct CellStandingParams {
  bool judged = true;         ///< Whether standing tracks are told from moving ones at all.
  double moving_odds = 5.0;   ///< Prior odds that a new track moves, > 0.
  double known_odds = 0.02;   ///< The same where something was found to stand before, > 0.
  double speed_sigma = 1.5;   ///< Of either velocity component of what moves [unit/s], > 0.
  double least_moving = 0.3;  ///< Probability of moving below which a track counts as standing, in (0, 1).
  int min_age = 4;            ///< Frames before that is judged, >= 1.
  int early_frames = 6;       ///< Frames from the first, of which all that stands is new, >= 0.
  int early_age = 15;         ///< Age at which tracks that began then are judged, >= 1.
  double mark_time = 5.0;     ///< After which what goes along with the sensor may be confirmed [s], >= 0.
  double memory = 60.0;       ///< How long a standing place is known [s], > 0.
};

/// Of the filter, nested by step.
struct CellTrackerParams {
  ScaleSpaceParams scales;            ///< Which signatures are looked for.
  CellMeasurementParams measurement;  ///< How a target is measured.
  CellMotionParams motion;            ///< How a target moves.
  CellCourseParams course;            ///< And changes its course, as far as it is published.
  CellExistenceParams existence;      ///< When a target is believed.
  CellStandingParams standing;        ///< What is no target.
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const CellTrackerParams& params);

}  // namespace lookout::tracking
