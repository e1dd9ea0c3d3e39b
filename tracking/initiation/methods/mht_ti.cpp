// Source: modified Hough transform from temporary tracks, MHT-TI, as described by [Fan2018] section III.
#include "tracking/initiation/methods/mht_ti.hpp"

namespace lookout::tracking {
namespace {

constexpr double kMinVotes = 2.0;  // One pair alone is no line.

}  // namespace

PairVotingInitiator::PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds)
    : params_(params), formation_(speeds, kMaxPairs, params.gate_margin), grid_(1, 1, 1.0) {
  params_.validate();
  params_.min_votes = kMinVotes;
}

const StartedTracks& PairVotingInitiator::start(const PlotWindow& window) {
  started_.clear();
  grid_ = grid_over(window, params_);
  if (!vote(window)) return started_;
  sort_by_theta(pairs_);
  declare_tracks(window, {grid_, votes_, pairs_}, params_, candidates_, builder_, started_);
  return started_;
}

bool PairVotingInitiator::vote(const PlotWindow& window) {
  votes_.clear();
  pairs_.clear();
  formation_.restart();
  for (int scan = 1; scan < window.num_scans(); ++scan) {
    const auto& step = formation_.form(window, scan, Eigen::Vector2d::Zero());
    if (formation_.exceeded()) {
      started_.refusal = formation_.refusal();
      return false;
    }
    for (const PairPoint& pair : step) votes_.add(grid_.index(grid_.cell_of(pair.line)), 1.0);
    pairs_.insert(pairs_.end(), step.begin(), step.end());
  }
  return true;
}

void PairVotingInitiator::append_cells(std::vector<LineVote>& cells) const {
  append_votes(grid_, votes_, cells);
}

std::unique_ptr<Initiator> make_mht_ti(const InitiatorConfig& config) {
  chosen_variant(config, "mht_ti", {});
  return std::make_unique<PairVotingInitiator>(line_voting_params(config), SpeedLimits{});
}

}  // namespace lookout::tracking
