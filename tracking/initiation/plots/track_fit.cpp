#include "tracking/initiation/plots/track_fit.hpp"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

namespace lookout::tracking {

double Innovation::squared_distance() const {
  return residual.dot(covariance.inverse() * residual);
}

TrackFit two_point_start(const Plot& older, const Plot& newer, const MotionModelParams& motion) {
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
  return fit;
}

TrackFit predicted(const TrackFit& fit, double time, const MotionModelParams& motion) {
  TrackFit ahead = fit;
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

TrackFit fit_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion) {
  assert(plots.size() >= 2);
  TrackFit fit = two_point_start(window.plot(plots[0]), window.plot(plots[1]), motion);
  for (const int index : plots.subspan(2)) {
    const Plot& plot = window.plot(index);
    const TrackFit ahead = predicted(fit, plot.time, motion);
    fit = updated(ahead, plot, innovation(ahead, plot));
  }
  return fit;
}

StartedTrack& add_track(const PlotWindow& window, std::span<const int> plots, const MotionModelParams& motion,
                        double score, StartedTracks& started) {
  const TrackFit fit = fit_track(window, plots, motion);
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
