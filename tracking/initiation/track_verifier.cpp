// Source: our own; docs/initiators.md, "On the sonar".
#include "tracking/initiation/track_verifier.hpp"

#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/plots/false_chains.hpp"

namespace lookout::tracking {
namespace {

/// Covariance of the position that a course had or will have, `seconds` from its own time [m^2].
Eigen::Matrix2d position_covariance(const TrackFit& course, double seconds, const MotionModelParams& motion) {
  const Eigen::Matrix4d& covariance = course.track.covariance;
  const Eigen::Matrix2d mixed = covariance.topRightCorner<2, 2>() + covariance.bottomLeftCorner<2, 2>();
  const double bend = 0.5 * motion.acceleration_sigma * seconds * seconds;
  return covariance.topLeftCorner<2, 2>() + seconds * mixed +
         seconds * seconds * covariance.bottomRightCorner<2, 2>() + bend * bend * Eigen::Matrix2d::Identity();
}

}  // namespace

void TrackVerifierParams::validate() const {
  speeds.validate();
  motion.validate();
  core::require(std::isfinite(speeds.max), "max_speed must be finite", speeds.max);
  core::require(min_plots >= 3, "min_plots must be >= 3", min_plots);
  core::require_inner_share("chain_probability", chain_probability);
  core::require_not_negative("margin_sigmas", margin_sigmas);
  core::require(max_false_tracks > 0.0, "max_false_tracks must be > 0", max_false_tracks);
  if (clutter_per_area)
    core::require(*clutter_per_area > 0.0, "clutter_per_area must be > 0", *clutter_per_area);
  core::require(passes >= 1, "passes must be >= 1", passes);
}

TrackVerifier::TrackVerifier(const TrackVerifierParams& params)
    : params_(params), gate_(chi_square_gate(params.gate_probability, 2)) {
  params.validate();
}

const VerifiedCourse* TrackVerifier::verify(const PlotWindow& window, const StartedTrack& track) {
  TrackFit course;
  course.track.state = track.state;
  course.track.covariance = track.covariance;
  course.time = track.last_time;
  add_speed_prior(params_.speeds.max, course);
  for (int pass = 0; pass < params_.passes; ++pass) {
    choose(window, course);
    if (static_cast<int>(course_.plots.size()) < params_.min_plots) return nullptr;
    course = fit(window);
  }
  const double bound = chi_square_gate(params_.chain_probability, 2 * course.plots - 4);
  course_.log_expected =
      log_false_chains(log_false_ + course.log_volume, course.chi_square, course.plots, window.num_scans());
  const bool stands = course.chi_square <= bound &&
                      speed_allowed(course, params_.speeds, params_.margin_sigmas) &&
                      course_.log_expected <= std::log(params_.max_false_tracks);
  return stands ? &course_ : nullptr;
}

/// Of each scan the plot nearest to the course, in units of the covariance of both.
void TrackVerifier::choose(const PlotWindow& window, const TrackFit& course) {
  course_.plots.clear();
  for (int scan = 0; scan < window.num_scans(); ++scan) {
    const double seconds = window.time(scan) - course.time;
    const Eigen::Vector2d expected = course.position_at(window.time(scan));
    const Eigen::Matrix2d covariance = position_covariance(course, seconds, params_.motion);
    int nearest = -1;
    double least = gate_;
    for (int i = window.first(scan); i < window.end(scan); ++i) {
      const Plot& plot = window.plot(i);
      const double distance = squared_distance(plot.position - expected, covariance + plot.noise);
      if (distance > least) continue;
      nearest = i;
      least = distance;
    }
    if (nearest >= 0) course_.plots.push_back(nearest);
  }
}

/// The chosen plots' own fit, and what clutter makes of as many: any plot of the first scan, any in reach of
/// it by the speed limit in the second, and those inside the innovation's ellipse from then on.
TrackFit TrackVerifier::fit(const PlotWindow& window) {
  const Plot& first = window.plot(course_.plots[0]);
  const Plot& second = window.plot(course_.plots[1]);
  const double noise = std::sqrt((first.noise + second.noise).trace());
  const double reach = params_.speeds.max * (second.time - first.time) + params_.margin_sigmas * noise;
  log_false_ =
      std::log(window.size(first.scan) * std::numbers::pi * reach * reach) + log_density(window, second);
  TrackFit fit = two_point_start(first, second, params_.motion);
  add_speed_prior(params_.speeds.max, fit);
  for (std::size_t k = 2; k < course_.plots.size(); ++k) {
    const Plot& plot = window.plot(course_.plots[k]);
    const TrackFit ahead = predicted(fit, plot.time, params_.motion);
    fit = updated(ahead, plot, innovation(ahead, plot));
    log_false_ += log_density(window, plot);
  }
  return fit;
}

double TrackVerifier::log_density(const PlotWindow& window, const Plot& plot) const {
  if (params_.clutter_per_area) return std::log(*params_.clutter_per_area);
  if (plot.clutter_density > 0.0) return std::log(plot.clutter_density);
  return std::log(window.num_plots() / (window.num_scans() * covered_area(window)));
}

}  // namespace lookout::tracking
