// Source: sequence Hough transform (SHT-S, SHT-L), as compared against by [Zeng2023] section 3.2, Table 2.
#include "tracking/initiation/methods/sequence_ht.hpp"

#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kMaxVotes = 1'000'000'000;  // A few seconds.

}  // namespace

SequenceHtInitiator::SequenceHtInitiator(const SequenceHtParams& params)
    : params_(params), grid_(params.grid.num_theta, params.grid.num_rho, params.grid.half_range) {
  core::require(params.num_tracks >= 1, "num_tracks must be >= 1", params.num_tracks);
  core::require(params.min_plots >= 2, "min_plots must be >= 2", params.min_plots);
  core::require(params.window_scans >= 2, "window_scans must be >= 2", params.window_scans);
  params.motion.validate();
}

const StartedTracks& SequenceHtInitiator::start(const PlotWindow& window) {
  started_.clear();
  if (window.num_scans() < 2) return started_;
  if (static_cast<std::int64_t>(window.num_plots()) * grid_.num_theta() * params_.num_tracks > kMaxVotes) {
    started_.refusal =
        "more than " + std::to_string(kMaxVotes) + " votes; use fewer plots or a larger theta_step";
    return started_;
  }
  taken_.assign(static_cast<std::size_t>(window.num_plots()), 0);
  for (int round = 0; round < params_.num_tracks; ++round) {
    const LineVote highest = highest_cell(window);
    if (highest.value < 1.0) break;
    take_line(window, highest);
  }
  started_.survivors = started_.plots;
  return started_;
}

/// Of the plots that are left; the lowest cell number among equals.
LineVote SequenceHtInitiator::highest_cell(const PlotWindow& window) {
  votes_.reset(grid_);
  for (int i = 0; i < window.num_plots(); ++i) {
    if (!taken_[static_cast<std::size_t>(i)]) voting_.vote(grid_, window.plot(i).position, votes_);
  }
  const int most = votes_.most();
  if (most == 0) return {};
  cells_.clear();
  votes_.collect(grid_, most, 1, cells_);
  return cells_.front();
}

void SequenceHtInitiator::take_line(const PlotWindow& window, const LineVote& highest) {
  const NormalLine line = grid_.centre(highest.cell);
  const Eigen::Vector2d normal = line.normal();
  builder_.clear();
  members_.clear();
  for (int i = 0; i < window.num_plots(); ++i) {
    char& taken = taken_[static_cast<std::size_t>(i)];
    if (taken || grid_.row_of(window.plot(i).position.dot(normal)) != highest.cell.rho) continue;
    taken = 1;
    builder_.add(i, 1.0);
    members_.push_back(i);
  }
  if (!builder_.build(window, line, params_.min_plots, params_.motion, highest.value, started_)) return;
  // The refit takes one plot a scan; the track lists all that its cell holds.
  StartedTrack& track = started_.tracks.back();
  started_.plots.resize(static_cast<std::size_t>(track.first_plot));
  started_.plots.insert(started_.plots.end(), members_.begin(), members_.end());
  track.num_plots = static_cast<int>(members_.size());
}

std::unique_ptr<Initiator> make_sequence_ht(const InitiatorConfig& config) {
  chosen_variant(config, "sequence_ht", {});
  SequenceHtParams params;
  params.grid = zeng_grid(config);
  params.num_tracks = config.max_tracks.value_or(params.num_tracks);
  params.window_scans = config.window_scans.value_or(params.window_scans);
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(1.0);
  return std::make_unique<SequenceHtInitiator>(params);
}

}  // namespace lookout::tracking
