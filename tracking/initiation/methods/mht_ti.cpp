// Source: modified Hough transform from temporary tracks, MHT-TI, as described by [Fan2018] section III.
#include "tracking/initiation/methods/mht_ti.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMinVotes = 2.0;  // One pair alone is no line.

}  // namespace

PairVotingInitiator::PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds)
    : PairVotingInitiator(params, speeds, kMaxPairs) {
  params_.min_votes = kMinVotes;
}

PairVotingInitiator::PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds,
                                         std::int64_t max_pairs)
    : grid_(1, 1, 1.0), params_(params), formation_(speeds, max_pairs, params.gate_margin) {
  params_.validate();
}

const StartedTracks& PairVotingInitiator::start(const PlotWindow& window) {
  started_.clear();
  grid_ = grid_over(window, params_);
  if (take_steps(window)) declare(window);
  return started_;
}

bool PairVotingInitiator::take_steps(const PlotWindow& window) {
  votes_.clear();
  voters_.clear();
  begin_window();
  formation_.restart();
  for (int scan = 1; scan < window.num_scans(); ++scan) {
    const auto& step = formation_.form(window, scan, Eigen::Vector2d::Zero());
    if (formation_.exceeded()) {
      started_.refusal = formation_.refusal();
      return false;
    }
    take_step(step);
  }
  return true;
}

void PairVotingInitiator::take_step(const std::vector<PairPoint>& step) {
  for (const PairPoint& pair : step) {
    vote(grid_.cell_of(pair.line), 1.0);
    note_voter(pair);
  }
}

/// The pairs in the neighbourhood of each declared line choose its plots.
void PairVotingInitiator::declare(const PlotWindow& window) {
  sort_by_theta(voters_);
  const double theta_reach = 2.0 * params_.theta_tolerance;
  const double rho_reach = 2.0 * params_.rho_tolerance;
  for (const LineVote& peak : declared_lines(grid_, votes_, params_, candidates_)) {
    const NormalLine line = grid_.centre(peak.cell);
    builder_.clear();
    for_pairs_near(voters_, line, theta_reach, rho_reach, [&](const PairPoint& pair, const NormalLine&) {
      builder_.add(pair.older, pair.weight);
      builder_.add(pair.newer, pair.weight);
    });
    builder_.build(window, line, params_.min_plots, params_.motion, peak.value, started_);
  }
  started_.survivors = started_.plots;
}

void PairVotingInitiator::append_cells(std::vector<LineVote>& cells) const {
  for (const auto& entry : votes_.entries()) cells.push_back({grid_.cell_at(entry.key), entry.total()});
}

std::unique_ptr<Initiator> make_mht_ti(const InitiatorConfig& config) {
  chosen_variant(config, "mht_ti", {});
  return std::make_unique<PairVotingInitiator>(line_voting_params(config), SpeedLimits{});
}

}  // namespace lookout::tracking
