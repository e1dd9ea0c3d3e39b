// Source: Zeng, Xiao, Ding, He, "Track initiation based on adaptive gates and fuzzy Hough transform", SIViP,
// 2023.
#include "tracking/initiation/methods/ag_fht.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr double kKnownSpeed = 500.0;   // Eastward [m/s].
constexpr double kKnownVariance = 1e4;  // Of a plot, north and east [m^2].

/// Values of the authors' program that the paper does not state; docs/initiators.md lists them.
void add_unstated_knowledge(GateLogicParams& gates) {
  gates.known_course = Eigen::Vector2d(1.0, 0.0);
  gates.known_velocity = Eigen::Vector2d(kKnownSpeed, 0.0);
  gates.drop_lonely_roots = true;
  gates.noise = kKnownVariance * Eigen::Matrix2d::Identity();
}

}  // namespace

ZengGridParams zeng_grid(const InitiatorConfig& config) {
  config.validate();
  ZengGridParams grid;
  grid.half_range = config.sensor_range.value_or(grid.half_range);
  if (config.rho_step) grid.num_rho = static_cast<int>(std::ceil(2.0 * grid.half_range / *config.rho_step));
  if (config.centred_rows) grid.num_rho |= 1;
  if (config.theta_step) grid.num_theta = static_cast<int>(std::ceil(std::numbers::pi / *config.theta_step));
  return grid;
}

AgFhtInitiator::AgFhtInitiator(const AgFhtParams& params)
    : params_(params),
      grid_(params.grid.num_theta, params.grid.num_rho, params.grid.half_range),
      gates_(params.gates) {
  core::require(params.min_plots >= 2, "min_plots must be >= 2", params.min_plots);
  core::require(params.window_scans >= 2, "window_scans must be >= 2", params.window_scans);
  core::require(params.min_hits >= 2 && params.min_hits <= params.min_plots,
                "min_hits must be in 2 .. min_plots", params.min_hits);
  core::require(params.reach >= 0, "reach must be >= 0", params.reach);
  core::require_positive("cell_sigma", params.cell_sigma);
  core::require_inner_share("share_of_highest", params.share_of_highest);
  core::require_inner_share("share_of_mean", params.share_of_mean);
  for (int i = 0; i < grid_.num_theta(); ++i) normals_.push_back(NormalLine{0.0, grid_.theta_of(i)}.normal());
}

const StartedTracks& AgFhtInitiator::start(const PlotWindow& window) {
  started_.clear();
  collect_candidates(window);
  const double least = threshold();
  for (const Candidate& candidate : candidates_) {
    if (candidate.peak <= 0.0 || candidate.peak <= least) continue;
    add_track(window, gates_.plots_of(candidate.track), params_.gates.motion, candidate.peak, started_).line =
        grid_.centre(candidate.cell);
  }
  return started_;
}

/// Candidates of the gates; those of identical plots are merged.
void AgFhtInitiator::collect_candidates(const PlotWindow& window) {
  candidates_.clear();
  for (const GateTrack& track : gates_.run(window)) {
    if (track.num_plots < params_.min_plots) continue;
    const auto plots = gates_.plots_of(track);
    const bool repeated = std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
      return std::ranges::equal(gates_.plots_of(other.track), plots);
    });
    if (repeated) continue;
    candidates_.push_back(transformed(window, track));
  }
  gates_.append_survivors(started_.survivors);
}

double AgFhtInitiator::rho_of(int plot, int column) const {
  return rho_[static_cast<std::size_t>(plot * grid_.num_theta() + column)];
}

/// The fuzzy Hough transform of one candidate: only its own plots vote.
AgFhtInitiator::Candidate AgFhtInitiator::transformed(const PlotWindow& window, const GateTrack& track) {
  rho_.clear();
  for (const int plot : gates_.plots_of(track)) {
    for (const auto& normal : normals_) rho_.push_back(window.plot(plot).position.dot(normal));
  }
  Candidate candidate{track, {}, 0.0};
  for (int column = 0; column < grid_.num_theta(); ++column) {
    for (int k = 0; k < track.num_plots; ++k) {
      const LineCell cell{column, grid_.row_of(rho_of(k, column))};
      if (!grid_.contains(cell)) continue;
      const double value = cell_value(cell, track.num_plots);
      if (value > candidate.peak) candidate = {track, cell, value};
    }
  }
  return candidate;
}

/// Crisp hits of a cell plus the memberships of the plots around it, Eq. (15); 0 with too few crisp hits.
double AgFhtInitiator::cell_value(const LineCell& cell, int num_plots) const {
  int hits = 0;
  for (int k = 0; k < num_plots; ++k) hits += grid_.row_of(rho_of(k, cell.theta)) == cell.rho ? 1 : 0;
  if (hits < params_.min_hits) return 0.0;
  double value = hits;
  for (int k = 0; k < num_plots; ++k) {
    for (int i = -params_.reach; i <= params_.reach; ++i) value += membership(cell, k, cell.theta + i);
  }
  return value;
}

/// Eq. (15): of plot k in a column near `cell`, 0 beyond the reach.
double AgFhtInitiator::membership(const LineCell& cell, int plot, int column) const {
  // Over the end of theta the column is that of the other end and rho changes its sign.
  const LineCell on_grid = grid_.wrapped({column, 0});
  const double sign = on_grid.theta == column ? 1.0 : -1.0;
  const double rows = (sign * rho_of(plot, on_grid.theta) - grid_.centre(cell).rho) / grid_.rho_step();
  if (std::abs(rows) > params_.reach) return 0.0;
  const double columns = column - cell.theta;
  return std::exp(-0.5 * (rows * rows + columns * columns) / (params_.cell_sigma * params_.cell_sigma));
}

/// Eq. (16).
double AgFhtInitiator::threshold() const {
  double highest = 0.0;
  for (const Candidate& candidate : candidates_) highest = std::max(highest, candidate.peak);
  double sum = 0.0;
  int count = 0;
  for (const Candidate& candidate : candidates_) {
    if (candidate.peak <= params_.share_of_highest * highest) continue;
    sum += candidate.peak;
    ++count;
  }
  return count > 0 ? params_.share_of_mean * sum / count : 0.0;
}

std::unique_ptr<Initiator> make_ag_fht(const InitiatorConfig& config) {
  const std::string variant = chosen_variant(
      config, "ag_fht", {"text", "text_outside_gates", "text_all_plots", "unstated_knowledge"});
  AgFhtParams params;
  params.grid = zeng_grid(config);
  params.gates.speeds = speed_limits(config, kZengSpeeds);
  params.gates.margin = config.gate_margin.value_or(config.range_sigma.value_or(params.gates.margin));
  params.gates.limit_turns(config.max_turn);
  params.gates.motion.acceleration_sigma = config.acceleration_sigma.value_or(1.0);
  params.min_plots = config.min_plots.value_or(params.min_plots);
  params.min_hits = config.min_hits.value_or(std::min(params.min_hits, params.min_plots));
  params.window_scans = config.window_scans.value_or(params.window_scans);
  params.share_of_mean = config.peak_threshold.value_or(params.share_of_mean);
  params.gates.new_roots = new_roots_of(variant);
  if (variant == "unstated_knowledge") add_unstated_knowledge(params.gates);
  return std::make_unique<AgFhtInitiator>(params);
}

}  // namespace lookout::tracking
