#include "tracking/initiation/plots/gate_logic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

void GateLogicParams::validate() const {
  speeds.validate();
  motion.validate();
  core::require_not_negative("margin", margin);
  core::require_not_negative("max_acceleration", max_acceleration);
  core::require(gate > 0.0, "gate must be > 0", gate);
  core::require(turn_rate > 0.0, "turn_rate must be > 0", turn_rate);
  if (max_turn) core::require_positive("max_turn", *max_turn);
  core::require(max_misses >= 0, "max_misses must be >= 0", max_misses);
}

NewRoots new_roots_of(const std::string& variant) {
  if (variant.ends_with("_outside_gates")) return NewRoots::outside_gates;
  return variant.ends_with("_all_plots") ? NewRoots::all : NewRoots::unclaimed;
}

void GateLogicParams::limit_turns(std::optional<double> angle) {
  max_turn = angle;
  fan_gate = fan_gate && angle.value_or(0.0) < 0.5 * std::numbers::pi;
}

GateLogic::GateLogic(const GateLogicParams& params) : params_(params) {
  params.validate();
}

std::span<const GateTrack> GateLogic::run(const PlotWindow& window) {
  tracks_.clear();
  plots_.clear();
  row_length_ = static_cast<std::size_t>(window.num_scans());
  gated_.assign(static_cast<std::size_t>(window.num_plots()), 0);
  claimed_.assign(gated_.size(), 0);
  if (window.num_scans() > 0) add_roots(window, 0);
  for (int scan = 1; scan < window.num_scans(); ++scan) take_scan(window, scan);
  return tracks_;
}

std::span<const int> GateLogic::plots_of(const GateTrack& track) const {
  const std::size_t first = static_cast<std::size_t>(track.row) * row_length_;
  return std::span(plots_).subspan(first, static_cast<std::size_t>(track.num_plots));
}

void GateLogic::append(int plot, GateTrack& track) {
  const std::size_t first = static_cast<std::size_t>(track.row) * row_length_;
  plots_[first + static_cast<std::size_t>(track.num_plots++)] = plot;
}

void GateLogic::append_survivors(std::vector<int>& plots) const {
  for (std::size_t i = 0; i < gated_.size(); ++i) {
    if (gated_[i]) plots.push_back(static_cast<int>(i));
  }
}

void GateLogic::offer(int plot, double distance, Choice& choice) {
  gated_[static_cast<std::size_t>(plot)] = 1;
  if (choice.plot < 0 || distance < choice.distance) choice = {plot, distance};
}

void GateLogic::add_roots(const PlotWindow& window, int scan) {
  for (int plot = window.first(scan); plot < window.end(scan); ++plot) {
    if (!may_be_root(plot, scan)) continue;
    GateTrack root;
    root.row = static_cast<int>(plots_.size() / row_length_);
    plots_.resize(plots_.size() + row_length_);
    append(plot, root);
    tracks_.push_back(root);
  }
}

bool GateLogic::may_be_root(int plot, int scan) const {
  const auto index = static_cast<std::size_t>(plot);
  if (scan == 0 || params_.new_roots == NewRoots::all) return true;
  return params_.new_roots == NewRoots::unclaimed ? claimed_[index] == 0 : gated_[index] == 0;
}

void GateLogic::take_scan(const PlotWindow& window, int scan) {
  index_.build(window, scan);
  for (GateTrack& track : tracks_) {
    const Choice choice = choose(window, scan, track);
    if (choice.plot >= 0)
      extend(window, choice.plot, track);
    else
      ++track.misses;
  }
  std::erase_if(tracks_, [&](const GateTrack& track) {
    return track.misses > params_.max_misses || (params_.drop_lonely_roots && track.num_plots == 1);
  });
  if (scan == 1 && !params_.drop_lonely_roots) add_roots(window, scan);
}

GateLogic::Choice GateLogic::choose(const PlotWindow& window, int scan, const GateTrack& track) {
  if (track.num_plots == 1) return circular_choice(window, scan, track);
  if (params_.fan_gate && track.num_plots == 2 && track.misses == 0) return fan_choice(window, scan, track);
  return elliptical_choice(window, scan, track);
}

double GateLogic::turn_over(double seconds) const {
  return params_.max_turn.value_or(params_.turn_rate * seconds);
}

bool GateLogic::on_course(const Eigen::Vector2d& displacement) const {
  return !params_.known_course || displacement.dot(*params_.known_course) >= 0.0;
}

/// Eq. (1); the nearest is that whose distance is nearest to the mean speed's, for the text names no
/// criterion.
GateLogic::Choice GateLogic::circular_choice(const PlotWindow& window, int scan, const GateTrack& track) {
  const Plot& root = window.plot(newest(track));
  const double seconds = window.time(scan) - root.time;
  const double expected = 0.5 * (params_.speeds.min + params_.speeds.max) * seconds;
  Choice choice;
  index_.near(root.position, params_.speeds.max * seconds + params_.margin, [&](int i) {
    const Eigen::Vector2d displacement = window.plot(i).position - root.position;
    if (!in_annulus(displacement, seconds, params_.speeds, params_.margin) || !on_course(displacement))
      return;
    offer(i, std::abs(displacement.norm() - expected), choice);
  });
  return choice;
}

/// Eq. (2); the nearest to the predicted position.
GateLogic::Choice GateLogic::fan_choice(const PlotWindow& window, int scan, const GateTrack& track) {
  const Eigen::Vector2d from = window.plot(newest(track)).position;
  const double seconds = window.time(scan) - window.plot(newest(track)).time;
  const Eigen::Vector2d expected =
      predicted(track.fit, window.time(scan), params_.motion).track.position() - from;
  const double depth = (params_.speeds.max - params_.speeds.min) * seconds +
                       0.5 * params_.max_acceleration * seconds * seconds + params_.margin;
  Choice choice;
  index_.near(from, expected.norm() + 0.5 * depth, [&](int i) {
    const Eigen::Vector2d reached = window.plot(i).position - from;
    if (in_fan(reached, expected, depth, turn_over(seconds)) && on_course(reached))
      offer(i, (reached - expected).norm(), choice);
  });
  return choice;
}

/// Eq. (4)-(6); the nearest in units of the innovation's covariance.
GateLogic::Choice GateLogic::elliptical_choice(const PlotWindow& window, int scan, const GateTrack& track) {
  const Plot& last = window.plot(newest(track));
  const Eigen::Vector2d leg =
      last.position - window.plot(plots_of(track)[static_cast<std::size_t>(track.num_plots) - 2]).position;
  const double turn = turn_over((window.time(scan) - last.time) / (track.misses + 1));
  const TrackFit ahead = predicted(track.fit, window.time(scan), params_.motion);
  const Eigen::Matrix2d expected = ahead.track.covariance.topLeftCorner<2, 2>();
  // The trace bounds the largest eigenvalue; the plot's own noise is about that of the newest.
  const double reach = std::sqrt(params_.gate * (expected + 2.0 * known(last).noise).trace());
  Choice choice;
  index_.near(ahead.track.position(), reach, [&](int i) {
    const Plot plot = known(window.plot(i));
    const double distance = innovation(ahead, plot).squared_distance();
    if (distance <= params_.gate && angle_between(plot.position - last.position, leg) <= turn)
      offer(i, distance, choice);
  });
  return choice;
}

Plot GateLogic::known(const Plot& plot) const {
  Plot copy = plot;
  if (params_.noise) copy.noise = *params_.noise;
  return copy;
}

TrackFit GateLogic::start_fit(const Plot& older, const Plot& newer) const {
  if (!params_.known_velocity) return two_point_start(older, newer, params_.motion);
  // The older plot with the known velocity, as sure of it as two plots would be, then the newer plot.
  TrackFit fit = two_point_start(older, newer, params_.motion);
  fit.track.state << older.position, *params_.known_velocity;
  fit.time = older.time;
  const TrackFit ahead = predicted(fit, newer.time, params_.motion);
  return updated(ahead, newer, innovation(ahead, newer));
}

void GateLogic::extend(const PlotWindow& window, int plot, GateTrack& track) {
  const Plot newer = known(window.plot(plot));
  const Plot older = known(window.plot(newest(track)));
  if (track.num_plots == 1) {
    track.fit = start_fit(older, newer);
  } else if (params_.filtered) {
    const TrackFit ahead = predicted(track.fit, newer.time, params_.motion);
    track.fit = updated(ahead, newer, innovation(ahead, newer));
  } else {
    track.fit = two_point_start(older, newer, params_.motion);
  }
  for (const int own : plots_of(track)) gated_[static_cast<std::size_t>(own)] = 1;
  append(plot, track);
  claimed_[static_cast<std::size_t>(plot)] = 1;
  track.misses = 0;
}

}  // namespace lookout::tracking
