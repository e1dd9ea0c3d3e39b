#include "tracking/initiation/plots/track_fit.hpp"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

#include "core/constant_velocity.hpp"

namespace lookout::tracking {
namespace {

/// How a velocity turns over a step, and the way that it makes: x += way v, v = turn v.
struct Turn {
  Eigen::Matrix2d turn;
  Eigen::Matrix2d way;
};

Turn turn_over(double seconds, double rate) {
  Eigen::Matrix2d quarter;
  quarter << 0.0, -1.0, 1.0, 0.0;
  const double angle = rate * seconds;
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  return {std::cos(angle) * one + std::sin(angle) * quarter,
          (std::sin(angle) * one + (1.0 - std::cos(angle)) * quarter) / rate};
}

/// `predict` along a turn. [BarShalom2001] Eq. (11.7.1-4).
void predict_turn(core::Track& track, double seconds, double rate, const MotionModelParams& motion) {
  const Turn step = turn_over(seconds, rate);
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F.topRightCorner<2, 2>() = step.way;
  F.bottomRightCorner<2, 2>() = step.turn;
  track.state = (F * track.state).eval();
  track.covariance = (F * track.covariance * F.transpose()).eval() +
                     core::stepwise_acceleration_noise(seconds, motion.acceleration_sigma);
}

}  // namespace

double Innovation::squared_distance() const {
  return residual.dot(covariance.inverse() * residual);
}

TrackFit two_point_start(const Plot& older, const Plot& newer, const MotionModelParams& motion,
                         double turn_rate) {
  const double seconds = newer.time - older.time;
  assert(seconds > 0.0);
  // The mean velocity of the step plus half of the change that the acceleration makes over it.
  const double half_change = 0.5 * seconds * motion.acceleration_sigma;
  TrackFit fit;
  fit.track.state << newer.position, (newer.position - older.position) / seconds;
  fit.track.covariance << newer.noise, newer.noise / seconds, newer.noise / seconds,
      (older.noise + newer.noise) / (seconds * seconds) +
          half_change * half_change * Eigen::Matrix2d::Identity();
  fit.time = newer.time;
  fit.plots = 2;
  fit.turn_rate = turn_rate;
  if (turn_rate == 0.0) return fit;
  // The newer velocity of the turn whose chord the step is.
  const Turn step = turn_over(seconds, turn_rate);
  Eigen::Matrix4d to_end = Eigen::Matrix4d::Identity();
  to_end.bottomRightCorner<2, 2>() = seconds * step.turn * step.way.inverse();
  fit.track.state = (to_end * fit.track.state).eval();
  fit.track.covariance = (to_end * fit.track.covariance * to_end.transpose()).eval();
  return fit;
}

TrackFit predicted(const TrackFit& fit, double time, const MotionModelParams& motion) {
  TrackFit ahead = fit;
  if (fit.turn_rate != 0.0 && time != fit.time)
    predict_turn(ahead.track, time - fit.time, fit.turn_rate, motion);
  else
    predict(ahead.track, time - fit.time, motion);
  ahead.time = time;
  return ahead;
}

Innovation innovation(const TrackFit& fit_at_plot, const Plot& plot) {
  return {plot.position - fit_at_plot.track.position(),
          fit_at_plot.track.covariance.topLeftCorner<2, 2>() + plot.noise};
}

TrackFit updated(const TrackFit& fit_at_plot, const Plot& plot, const Innovation& innovation) {
  TrackFit fit = fit_at_plot;
  fit.chi_square += innovation.squared_distance();
  fit.log_volume += 0.5 * std::log(innovation.covariance.determinant());
  update(fit.track, plot.position, plot.noise);
  ++fit.plots;
  return fit;
}

TrackFit fit_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion,
                   double turn_rate) {
  assert(plots.size() >= 2);
  TrackFit fit = two_point_start(window.plot(plots[0]), window.plot(plots[1]), motion, turn_rate);
  for (const int index : plots.subspan(2)) {
    const Plot& plot = window.plot(index);
    const TrackFit ahead = predicted(fit, plot.time, motion);
    fit = updated(ahead, plot, innovation(ahead, plot));
  }
  return fit;
}

StartedTrack& add_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion,
                        double score, StartedTracks& started, double turn_rate) {
  const TrackFit fit = fit_track(window, plots, motion, turn_rate);
  const Plot& oldest = window.plot(plots.front());
  const Plot& newest = window.plot(plots.back());
  StartedTrack track;
  track.state = fit.track.state;
  track.covariance = fit.track.covariance;
  track.score = score;
  track.first_scan = oldest.scan;
  track.last_scan = newest.scan;
  track.first_time = oldest.time;
  track.last_time = newest.time;
  track.first_plot = static_cast<int>(started.plots.size());
  track.num_plots = static_cast<int>(plots.size());
  const auto course = line_through(track.initial_position(), track.state.head<2>());
  track.line = course.value_or(NormalLine{track.state.x(), 0.0});
  started.plots.insert(started.plots.end(), plots.begin(), plots.end());
  started.tracks.push_back(track);
  return started.tracks.back();
}

}  // namespace lookout::tracking
