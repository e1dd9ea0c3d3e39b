#include "tracking/initiation/lines/line_voting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

/// Rows at which a grid is refused: a window of points far away with metre cells is a mistake of units.
constexpr double kMaxRows = 4e6;

}  // namespace

void LineVotingParams::validate() const {
  constexpr double kFewestColumns = 4.0;  // of half a turn
  core::require_positive("rho_step", rho_step);
  core::require(theta_step > 0.0 && theta_step <= std::numbers::pi / kFewestColumns,
                "theta_step must be in (0, pi/4]", theta_step);
  core::require_positive("rho_tolerance", rho_tolerance);
  core::require_positive("theta_tolerance", theta_tolerance);
  core::require_not_negative("min_votes", min_votes);
  core::require_share("peak_threshold", peak_threshold);
  core::require(min_plots >= 2, "min_plots must be >= 2", min_plots);
  core::require(window_scans >= 2, "window_scans must be >= 2", window_scans);
  core::require(max_tracks >= 1, "max_tracks must be >= 1", max_tracks);
  core::require_not_negative("gate_margin", gate_margin);
  motion.validate();
}

int LineVotingParams::rho_radius() const {
  return static_cast<int>(std::ceil(2.0 * rho_tolerance / rho_step - 1e-9));
}

int LineVotingParams::theta_radius() const {
  return static_cast<int>(std::ceil(2.0 * theta_tolerance / theta_step - 1e-9));
}

PeakParams LineVotingParams::peaks() const {
  PeakParams peaks;
  peaks.theta_radius = theta_radius();
  peaks.rho_radius = rho_radius();
  peaks.max_peaks = max_tracks;
  return peaks;
}

LineVotingParams line_voting_params(const InitiatorConfig& config) {
  config.validate();
  LineVotingParams params;
  params.rho_step = config.rho_step.value_or(params.rho_step);
  params.theta_step = config.theta_step.value_or(params.theta_step);
  params.rho_tolerance = config.rho_tolerance.value_or(params.rho_tolerance);
  params.theta_tolerance = config.theta_tolerance.value_or(params.theta_tolerance);
  params.peak_threshold = config.peak_threshold.value_or(params.peak_threshold);
  params.min_plots = config.min_plots.value_or(params.min_plots);
  params.max_tracks = config.max_tracks.value_or(params.max_tracks);
  params.window_scans = config.window_scans.value_or(params.window_scans);
  params.gate_margin = config.gate_margin.value_or(params.gate_margin);
  params.centred_rows = config.centred_rows;
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(0.0);
  return params;
}

LineGrid grid_over(const PlotWindow& window, const LineVotingParams& params) {
  const double half_rows = std::ceil(largest_distance(window) / params.rho_step) + 1.0;
  if (2.0 * half_rows > kMaxRows)
    throw std::invalid_argument(
        "rho_step must be >= " + std::to_string(2.0 * largest_distance(window) / kMaxRows) +
        " for these plots, got " + std::to_string(params.rho_step));
  const int num_theta = std::max(1, static_cast<int>(std::ceil(std::numbers::pi / params.theta_step)));
  const int middle = params.centred_rows ? 1 : 0;
  return {num_theta, 2 * static_cast<int>(half_rows) + middle, (half_rows + 0.5 * middle) * params.rho_step};
}

std::span<const LineVote> declared_lines(const LineGrid& grid, const SparseAccumulator& votes,
                                         const LineVotingParams& params, std::vector<LineVote>& candidates) {
  candidates.clear();
  double highest = 0.0;
  for (const auto& entry : votes.entries()) highest = std::max(highest, entry.total());
  if (highest <= 0.0) return {};
  const double least = std::max(params.min_votes, params.peak_threshold * highest);
  for (const auto& entry : votes.entries()) {
    const LineVote vote{grid.cell_at(entry.key), entry.total()};
    const auto votes_of = [&](const LineCell& cell) { return votes.value(grid.index(cell)); };
    if (vote.value >= least && is_local_maximum(grid, vote, votes_of)) candidates.push_back(vote);
  }
  return strongest_peaks(grid, params.peaks(), candidates);
}

}  // namespace lookout::tracking
