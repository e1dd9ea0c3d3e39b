// Source: Liang, Wang, Guo, fuzzy parallel Hough transform, 2015, as compared against by [Zeng2023] Table 2.
#include "tracking/initiation/methods/fpht.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kMaxVotes = 1'000'000'000;  // A few seconds.

}  // namespace

FphtInitiator::FphtInitiator(const FphtParams& params)
    : params_(params), grid_(params.grid.num_theta, params.grid.num_rho, params.grid.half_range) {
  core::require_share("peak_threshold", params.peak_threshold);
  core::require(params.reach >= 0, "reach must be >= 0", params.reach);
  core::require_positive("cell_sigma", params.cell_sigma);
  core::require(params.min_plots >= 2, "min_plots must be >= 2", params.min_plots);
  core::require(params.window_scans >= 2, "window_scans must be >= 2", params.window_scans);
  core::require(params.max_tracks >= 1, "max_tracks must be >= 1", params.max_tracks);
  for (int i = 0; i < grid_.num_theta(); ++i) normals_.push_back(NormalLine{0.0, grid_.theta_of(i)}.normal());
}

const StartedTracks& FphtInitiator::start(const PlotWindow& window) {
  started_.clear();
  if (window.num_scans() < 2) return started_;
  const std::int64_t votes = static_cast<std::int64_t>(window.num_plots()) * grid_.num_theta();
  if (votes * (2 * params_.reach + 1) > kMaxVotes) {
    started_.refusal =
        "more than " + std::to_string(kMaxVotes) + " votes; use fewer plots or a larger theta_step";
    return started_;
  }
  vote(window);
  declare(window);
  return started_;
}

void FphtInitiator::vote(const PlotWindow& window) {
  const auto num_cells = static_cast<std::size_t>(grid_.num_cells());
  votes_.assign(num_cells, 0.0f);
  for (int scan = 0; scan < window.num_scans(); ++scan) {
    scan_votes_.assign(num_cells, 0.0f);
    vote_scan(window, scan);
    for (std::size_t i = 0; i < num_cells; ++i) votes_[i] += scan_votes_[i];
  }
}

void FphtInitiator::vote_scan(const PlotWindow& window, int scan) {
  for (const Plot& plot : window.scan(scan)) {
    for (int column = 0; column < grid_.num_theta(); ++column) {
      const int row = grid_.row_of(plot.position.dot(normals_[static_cast<std::size_t>(column)]));
      for (int j = row - params_.reach; j <= row + params_.reach; ++j) {
        const LineCell cell{column, j};
        if (!grid_.contains(cell)) continue;
        float& held = scan_votes_[static_cast<std::size_t>(grid_.index(cell))];
        held = std::max(held, static_cast<float>(membership(cell, plot.position)));
      }
    }
  }
}

double FphtInitiator::membership(const LineCell& cell, const Eigen::Vector2d& position) const {
  const double rho = position.dot(normals_[static_cast<std::size_t>(cell.theta)]);
  const double rows = (rho - grid_.centre(cell).rho) / (grid_.rho_step() * params_.cell_sigma);
  return std::exp(-0.5 * rows * rows);
}

void FphtInitiator::declare(const PlotWindow& window) {
  const float highest = *std::max_element(votes_.begin(), votes_.end());
  if (highest <= 0.0f) return;
  candidates_.clear();
  const auto votes_of = [&](const LineCell& cell) {
    return votes_[static_cast<std::size_t>(grid_.index(cell))];
  };
  for (std::int64_t i = 0; i < grid_.num_cells(); ++i) {
    const LineVote vote{grid_.cell_at(i), votes_[static_cast<std::size_t>(i)]};
    if (vote.value >= params_.peak_threshold * highest && is_local_maximum(grid_, vote, votes_of))
      candidates_.push_back(vote);
  }
  PeakParams peaks;
  peaks.theta_radius = params_.reach;
  peaks.rho_radius = params_.reach;
  peaks.max_peaks = params_.max_tracks;
  for (const LineVote& peak : strongest_peaks(grid_, peaks, candidates_)) {
    builder_.clear();
    const NormalLine line = grid_.centre(peak.cell);
    const Eigen::Vector2d normal = line.normal();
    const double reach = (params_.reach + 0.5) * grid_.rho_step();
    for (int i = 0; i < window.num_plots(); ++i) {
      const Eigen::Vector2d& position = window.plot(i).position;
      if (std::abs(position.dot(normal) - line.rho) <= reach)
        builder_.add(i, membership(peak.cell, position));
    }
    builder_.build(window, line, params_.min_plots, params_.motion, peak.value, started_);
  }
  started_.survivors = started_.plots;
}

void FphtInitiator::append_cells(std::vector<LineVote>& cells) const {
  for (std::size_t i = 0; i < votes_.size(); ++i) {
    if (votes_[i] > 0.0f) cells.push_back({grid_.cell_at(static_cast<std::int64_t>(i)), votes_[i]});
  }
}

std::unique_ptr<Initiator> make_fpht(const InitiatorConfig& config) {
  chosen_variant(config, "fpht", {});
  FphtParams params;
  params.grid = zeng_grid(config);
  params.peak_threshold = config.peak_threshold.value_or(params.peak_threshold);
  params.min_plots = config.min_plots.value_or(params.min_plots);
  params.max_tracks = config.max_tracks.value_or(params.max_tracks);
  params.window_scans = config.window_scans.value_or(params.window_scans);
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(1.0);
  return std::make_unique<FphtInitiator>(params);
}

}  // namespace lookout::tracking
