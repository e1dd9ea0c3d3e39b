// Source: Fan, Xie, Pei, Hu, Li, "Neutrosophic Hough Transform-Based Track Initiation ...", IEEE Access,
// 2018.
#include "tracking/initiation/methods/nht_ti.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

NhtTiInitiator::NhtTiInitiator(const NhtTiParams& params)
    : PairVotingInitiator(params.lines, params.speeds, kMaxPairs), params_(params) {
  core::require_not_negative("false_degree_factor", params.false_degree_factor);
  core::require_not_negative("least_vote", params.least_vote);
  core::require_share_below_one("false_alarm_probability", params.false_alarm_probability);
}

void NhtTiInitiator::take_step(const std::vector<PairPoint>& step) {
  for (PairPoint pair : step) {
    pair.weight = degree_of(pair);
    if (pair.weight < params_.least_vote) continue;
    note_voter(pair);
    if (params_.vote == NhtVote::cell)
      vote(grid_.cell_of(pair.line), pair.weight);
    else
      spread_vote(pair.line, pair.weight);
  }
  kernels_ = step;
  sort_by_theta(kernels_);
}

/// Eq. (15), (27): how well two lines agree.
double NhtTiInitiator::membership(const NormalLine& apart) const {
  const double rho = apart.rho / params_.lines.rho_tolerance;
  const double theta = apart.theta / params_.lines.theta_tolerance;
  return std::exp(-0.5 * (rho * rho + theta * theta));
}

/// mu_C of Eq. (24): the maximum of the three degrees, and 1 - P_F where no step before can tell. The kernels
/// are those inside the neighbourhood of Eq. (28).
double NhtTiInitiator::degree_of(const PairPoint& pair) {
  if (kernels_.empty()) return 1.0 - params_.false_alarm_probability;
  competing_.clear();
  for_pairs_near(kernels_, pair.line, 2.0 * params_.lines.theta_tolerance, 2.0 * params_.lines.rho_tolerance,
                 [&](const PairPoint& kernel, const NormalLine& apart) {
                   if (!params_.chained || kernel.newer == pair.older) competing_.push_back(apart);
                 });
  std::sort(competing_.begin(), competing_.end(),
            [this](const NormalLine& a, const NormalLine& b) { return membership(a) > membership(b); });
  const double is_true = competing_.empty() ? 0.0 : membership(competing_[0]);  // Eq. (27)
  double is_uncertain = 0.0;
  if (competing_.size() >= 2) {
    // The line midway between the two best kernels.
    const NormalLine between{0.5 * (competing_[0].rho + competing_[1].rho),
                             0.5 * (competing_[0].theta + competing_[1].theta)};
    is_uncertain = membership(between);
  }
  const double probability = params_.false_alarm_probability;
  const double is_false = params_.false_degree_factor * probability * probability;  // Eq. (29)
  return std::max({is_true, is_uncertain, is_false});
}

/// mu_C times the membership of every cell of the neighbourhood, Eq. (15).
void NhtTiInitiator::spread_vote(const NormalLine& line, double weight) {
  const LineCell own = grid_.cell_of(line);
  const int rows = params_.lines.rho_radius();
  const int columns = params_.lines.theta_radius();
  row_membership_.clear();
  for (int j = -rows; j <= rows; ++j)
    row_membership_.push_back(membership({grid_.centre({own.theta, own.rho + j}).rho - line.rho, 0.0}));
  for (int i = -columns; i <= columns; ++i) {
    const double column_weight = weight * membership({0.0, grid_.theta_of(own.theta + i) - line.theta});
    for (int row = 0; row <= 2 * rows; ++row) {
      const LineCell cell = grid_.wrapped({own.theta + i, own.rho - rows + row});
      if (grid_.contains(cell)) vote(cell, column_weight * row_membership_[static_cast<std::size_t>(row)]);
    }
  }
}

std::unique_ptr<Initiator> make_nht_ti(const InitiatorConfig& config) {
  const std::string variant =
      chosen_variant(config, "nht_ti", {"spread", "cell", "spread_chained", "cell_chained"});
  NhtTiParams params;
  params.lines = line_voting_params(config);
  params.speeds = speed_limits(config, kFanSpeeds);
  params.vote = variant.starts_with("cell") ? NhtVote::cell : NhtVote::spread;
  params.chained = variant.ends_with("_chained");
  return std::make_unique<NhtTiInitiator>(params);
}

}  // namespace lookout::tracking
