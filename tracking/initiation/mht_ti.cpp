// Source: modified Hough transform from temporary tracks, MHT-TI, as described by [Fan2018] section III.
#include "tracking/initiation/mht_ti.hpp"

#include <cmath>

namespace lookout::tracking {

PairVotingInitiator::PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds)
    : params_(params), formation_(speeds, kMaxPairs), grid_(1, 1, 1.0) {}

const StartedTracks& PairVotingInitiator::start(const PlotWindow& window) {
  started_.clear();
  grid_ = grid_over(window, params_);
  if (vote(window)) declare(window);
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

bool voted_for(const csht::NormalLine& pair, const csht::NormalLine& declared, const LineVotingParams& params) {
  const csht::NormalLine apart = csht::line_difference(pair, declared);
  return std::abs(apart.theta) <= 2.0 * params.theta_tolerance && std::abs(apart.rho) <= 2.0 * params.rho_tolerance;
}

void PairVotingInitiator::declare(const PlotWindow& window) {
  for (const csht::LineVote& peak : declared_lines(grid_, votes_, params_, candidates_)) {
    const csht::NormalLine line = grid_.centre(peak.cell);
    builder_.clear();
    for (const PairPoint& pair : pairs_) {
      if (!voted_for(pair.line, line, params_)) continue;
      builder_.add(pair.older, 1.0);
      builder_.add(pair.newer, 1.0);
    }
    builder_.build(window, line, params_.min_plots, params_.motion, peak.value, started_);
  }
  started_.survivors = started_.plots;
}

void PairVotingInitiator::append_cells(std::vector<csht::LineVote>& cells) const {
  append_votes(grid_, votes_, cells);
}

std::unique_ptr<Initiator> make_mht_ti(const InitiatorConfig& config) {
  chosen_variant(config, "mht_ti", {});
  return std::make_unique<PairVotingInitiator>(line_voting_params(config), SpeedLimits{});
}

}  // namespace lookout::tracking
