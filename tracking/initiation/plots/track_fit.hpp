#pragma once

#include <span>

#include "core/track.hpp"
#include "tracking/initiation/initiator.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {

/// A constant-velocity track fitted to plots, at the time of the newest of them.
struct TrackFit {
  core::Track track;  ///< State and covariance; the rest is unused.
  double time = 0.0;  ///< Of the newest plot [s].
  double chi_square =
      0.0;  ///< Squared residuals in units of their covariance, 2 (plots - 2) degrees of freedom.
  double log_volume = 0.0;  ///< Sum over these residuals of log sqrt(det S) [log m^2].
  int plots = 0;            ///< How many plots it rests on.
  double turn_rate = 0.0;   ///< At which its course turns [rad/s], from the first axis to the second.

  /// Position at the time `when` [s], along a straight course: north, east [m].
  Eigen::Vector2d position_at(double when) const {
    return track.position() + (when - time) * track.velocity();
  }
};

/// The exact state after two plots and no other knowledge: two-point differencing with the acceleration noise
/// of the step. [BarShalom2001] Sec. 5.5.3; [Zeng2023] Eq. (7)-(10).
/// @param turn_rate of the course [rad/s]: the step is its chord. [BarShalom2001] Eq. (11.7.1-4).
TrackFit two_point_start(const Plot& older, const Plot& newer, const MotionModelParams& motion,
                         double turn_rate = 0.0);

/// What a fit expects at the time of a plot: the residual and its covariance.
struct Innovation {
  Eigen::Vector2d residual{0, 0};                            ///< [m].
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< [m^2], the plot's own noise included.
  double squared_distance() const;                           ///< Of the residual under its covariance.
};

/// The fit carried to `time` [s] without a plot.
TrackFit predicted(const TrackFit& fit, double time, const MotionModelParams& motion);

/// Residual of a plot to a fit that was predicted to its time.
Innovation innovation(const TrackFit& fit_at_plot, const Plot& plot);

/// Takes a plot into a fit that was predicted to its time.
TrackFit updated(const TrackFit& fit_at_plot, const Plot& plot, const Innovation& innovation);

/// Weighted least squares of a constant-velocity course, its acceleration noise in the weight, over plots of
/// rising scans (at least two). Run as the filter, which gives the same state and chi-square in one pass.
TrackFit fit_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion,
                   double turn_rate = 0.0);

/// Adds a fitted track to `started`. Its line is the course of the fit.
/// @param plots of rising scans, at least two. @param turn_rate of the course [rad/s].
StartedTrack& add_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion,
                        double score, StartedTracks& started, double turn_rate = 0.0);

}  // namespace lookout::tracking
