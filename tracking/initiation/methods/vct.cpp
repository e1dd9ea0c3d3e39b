// Source: our own, velocity-consistent tracklets; docs/initiators.md. The threshold follows the a-contrario
// idea of Desolneux, Moisan, Morel, "Meaningful alignments", IJCV, 2000.
#include "tracking/initiation/methods/vct.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/initiation/plots/false_chains.hpp"

namespace lookout::tracking {
namespace {

constexpr double kFastestTurn = std::numbers::pi / 10;  // [rad/s]

/// So many standard deviations of the difference of two plots along their displacement [m].
double noise_margin(const Plot& a, const Plot& b, double sigmas) {
  const Eigen::Vector2d displacement = b.position - a.position;
  const double length = displacement.norm();
  if (length == 0.0) return 0.0;
  const Eigen::Vector2d along = displacement / length;
  return sigmas * std::sqrt(along.dot((a.noise + b.noise) * along));
}

/// The rates of turn that are tried [rad/s]: 0, then even steps to both sides up to the fastest.
std::vector<double> turn_rates(const VctParams& params) {
  std::vector<double> rates{0.0};
  const int steps = static_cast<int>(std::ceil(params.max_turn_rate / params.turn_rate_step - 1e-9));
  for (int k = 1; k <= steps; ++k) {
    const double rate = params.max_turn_rate * k / steps;
    rates.insert(rates.end(), {rate, -rate});
  }
  return rates;
}

}  // namespace

void VctParams::validate() const {
  speeds.validate();
  motion.validate();
  core::require(std::isfinite(speeds.max), "max_speed must be finite", speeds.max);
  core::require(window_scans >= 3, "window_scans must be >= 3", window_scans);
  core::require(min_plots >= 3 && min_plots <= window_scans, "min_plots must be in 3 .. window_scans",
                min_plots);
  core::require_inner_share("gate_probability", gate_probability);
  core::require_inner_share("chain_probability", chain_probability);
  core::require_not_negative("margin_sigmas", margin_sigmas);
  if (clutter_per_area) core::require_positive("clutter_per_area", *clutter_per_area);
  core::require(max_false_tracks > 0.0, "max_false_tracks must be > 0", max_false_tracks);
  core::require(max_turn_rate >= 0.0 && max_turn_rate <= kFastestTurn, "max_turn_rate must be in [0, pi/10]",
                max_turn_rate);
  core::require_positive("turn_rate_step", turn_rate_step);
  core::require(max_branches_per_plot >= 1, "max_branches_per_plot must be >= 1", max_branches_per_plot);
  core::require(max_branches >= 1, "max_branches must be >= 1", max_branches);
  core::require(max_consecutive_misses >= 0, "max_consecutive_misses must be >= 0", max_consecutive_misses);
}

VctInitiator::VctInitiator(const VctParams& params) : params_(params) {
  params.validate();
  gate_ = chi_square_gate(params.gate_probability, 2);
  chain_gates_.assign(3, 0.0);
  turn_rates_ = turn_rates(params);
  motion_ = params.motion;
  // A true rate lies up to half a step beside a tried one, evenly distributed: so much acceleration across
  // the course is left.
  const double step = turn_rates_.size() > 1 ? turn_rates_[1] : 0.0;
  const double left = params.speeds.max * step / std::sqrt(12.0);
  motion_.acceleration_sigma = std::hypot(params.motion.acceleration_sigma, left);
}

const StartedTracks& VctInitiator::start(const PlotWindow& window) {
  prepare(window);
  for (const double rate : turn_rates_) {
    if (search(window, rate)) continue;
    started_.refusal = "more than " + std::to_string(params_.max_branches) +
                       " branches in one window; use a smaller speed range or a shorter window";
    return started_;
  }
  declare(window);
  return started_;
}

/// Adds the chains of one way of turning. @return whether the search stays within its bound.
bool VctInitiator::search(const PlotWindow& window, double turn_rate) {
  turn_rate_ = turn_rate;
  branches_.clear();
  first_branch_.assign(static_cast<std::size_t>(window.num_plots()) + 1, 0);
  for (int scan = 0; scan < window.num_scans(); ++scan) {
    if (!grow(window, scan)) return false;
  }
  collect_chains();
  return true;
}

void VctInitiator::prepare(const PlotWindow& window) {
  started_.clear();
  chains_.clear();
  chain_plots_.clear();
  num_scans_ = window.num_scans();
  while (static_cast<int>(chain_gates_.size()) <= num_scans_)
    chain_gates_.push_back(
        chi_square_gate(params_.chain_probability, 2 * static_cast<int>(chain_gates_.size()) - 4));
  mean_density_ = window.num_plots() / (std::max(1, num_scans_) * covered_area(window));
}

/// Finds the branches that end in `scan`. @return whether the window stays within its bound.
bool VctInitiator::grow(const PlotWindow& window, int scan) {
  proposals_.clear();
  index_.build(window, scan);
  const int misses = std::min(params_.max_consecutive_misses, num_scans_ - params_.min_plots);
  for (int before = std::max(0, scan - 1 - misses); before < scan; ++before) {
    for (int plot = window.first(before); plot < window.end(before); ++plot) {
      propose_pairs(window, plot, scan);
      const auto first = first_branch_[static_cast<std::size_t>(plot)];
      const auto end = first_branch_[static_cast<std::size_t>(plot) + 1];
      for (int branch = first; branch < end; ++branch) propose_extensions(window, branch, scan);
    }
    if (proposals_.size() + branches_.size() > static_cast<std::size_t>(params_.max_branches)) return false;
  }
  keep_best(window);
  // Branches stand in order of plot: those of this scan end where the next scan's begin.
  auto next = static_cast<std::size_t>(window.first(scan));
  for (std::size_t b = next == 0 ? 0 : static_cast<std::size_t>(first_branch_[next]); b < branches_.size();
       ++b) {
    while (next < static_cast<std::size_t>(branches_[b].plot)) first_branch_[++next] = static_cast<int>(b);
  }
  while (next < static_cast<std::size_t>(window.end(scan)))
    first_branch_[++next] = static_cast<int>(branches_.size());
  return true;
}

/// Chains of two: as many false ones are expected as there are plots to begin with, times the clutter in the
/// annulus, times the ways in which K of N scans can be hit.
void VctInitiator::propose_pairs(const PlotWindow& window, int root, int scan) {
  const Plot& a = window.plot(root);
  if (scan + 1 - 2 > num_scans_ - params_.min_plots) return;
  const double seconds = window.time(scan) - a.time;
  const double slow = params_.speeds.min * seconds;
  const double fast = params_.speeds.max * seconds;
  // Noise of both plots at most: the trace bounds it in every direction.
  const double reach = fast + params_.margin_sigmas * std::sqrt(2.0 * a.noise.trace());
  index_.near(a.position, reach, [&](int i) {
    const Plot& b = window.plot(i);
    const double margin = noise_margin(a, b, params_.margin_sigmas);
    if (!in_annulus(b.position - a.position, seconds, params_.speeds, margin)) return;
    const double inner = std::max(0.0, slow - margin);
    const double area = std::numbers::pi * ((fast + margin) * (fast + margin) - inner * inner);
    const double log_false = std::log(window.size(a.scan)) + std::log(area) + log_density(b);
    proposals_.push_back({i, -1, root, log_false, log_expected(log_false, 0.0, 2)});
  });
}

void VctInitiator::propose_extensions(const PlotWindow& window, int branch, int scan) {
  const Branch& parent = branches_[static_cast<std::size_t>(branch)];
  if (scan - parent.fit.plots > num_scans_ - params_.min_plots) return;
  const TrackFit ahead = predicted(parent.fit, window.time(scan), motion_);
  const Plot& last = window.plot(parent.plot);
  const Eigen::Matrix2d spread = ahead.track.covariance.topLeftCorner<2, 2>() + last.noise;
  const double reach = std::sqrt(gate_ * spread.trace());
  index_.near(ahead.track.position(), reach, [&](int i) {
    const Plot& plot = window.plot(i);
    const Innovation step = innovation(ahead, plot);
    const double distance = step.squared_distance();
    if (distance > gate_) return;
    const double log_false =
        parent.log_false + log_density(plot) + 0.5 * std::log(step.covariance.determinant());
    const double chi_square = parent.fit.chi_square + distance;
    proposals_.push_back(
        {i, branch, parent.root, log_false, log_expected(log_false, chi_square, parent.fit.plots + 1)});
  });
}

double VctInitiator::log_expected(double log_false, double chi_square, int plots) const {
  return log_false_chains(log_false, chi_square, plots, num_scans_) +
         std::log(static_cast<double>(turn_rates_.size()));
}

double VctInitiator::log_density(const Plot& plot) const {
  if (params_.clutter_per_area) return std::log(*params_.clutter_per_area);
  return std::log(plot.clutter_density > 0.0 ? plot.clutter_density : mean_density_);
}

/// Of each plot the branches with the fewest false chains expected.
void VctInitiator::keep_best(const PlotWindow& window) {
  std::sort(proposals_.begin(), proposals_.end(), [](const Proposal& a, const Proposal& b) {
    return std::tuple(a.plot, a.log_expected, a.parent, a.root) <
           std::tuple(b.plot, b.log_expected, b.parent, b.root);
  });
  int plot = -1;
  int kept = 0;
  for (const Proposal& proposal : proposals_) {
    if (proposal.plot != plot) kept = 0;
    plot = proposal.plot;
    if (kept++ < params_.max_branches_per_plot) branches_.push_back(branch_of(window, proposal));
  }
}

VctInitiator::Branch VctInitiator::branch_of(const PlotWindow& window, const Proposal& proposal) const {
  const Plot& plot = window.plot(proposal.plot);
  Branch branch{{}, proposal.parent, proposal.root, proposal.plot, proposal.log_false, proposal.log_expected};
  if (proposal.parent < 0) {
    branch.fit = two_point_start(window.plot(proposal.root), plot, motion_, turn_rate_);
    add_speed_prior(params_.speeds.max, branch.fit);
  } else {
    const TrackFit ahead =
        predicted(branches_[static_cast<std::size_t>(proposal.parent)].fit, plot.time, motion_);
    branch.fit = updated(ahead, plot, innovation(ahead, plot));
  }
  return branch;
}

bool VctInitiator::accepted(const Branch& branch) const {
  const int plots = branch.fit.plots;
  if (plots < params_.min_plots) return false;
  if (branch.fit.chi_square > chain_gates_[static_cast<std::size_t>(plots)]) return false;
  if (branch.log_expected > std::log(params_.max_false_tracks)) return false;
  return speed_allowed(branch.fit, params_.speeds, params_.margin_sigmas);
}

void VctInitiator::collect_plots(int branch) {
  plots_.clear();
  for (int b = branch; b >= 0; b = branches_[static_cast<std::size_t>(b)].parent) {
    plots_.push_back(branches_[static_cast<std::size_t>(b)].plot);
    if (branches_[static_cast<std::size_t>(b)].parent < 0)
      plots_.push_back(branches_[static_cast<std::size_t>(b)].root);
  }
  std::reverse(plots_.begin(), plots_.end());
}

void VctInitiator::collect_chains() {
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    if (!accepted(branches_[b])) continue;
    collect_plots(static_cast<int>(b));
    chains_.push_back({branches_[b].log_expected, turn_rate_, chain_plots_.size(), plots_.size()});
    chain_plots_.insert(chain_plots_.end(), plots_.begin(), plots_.end());
  }
}

/// Greedy: the chain with the fewest false ones expected first, one plot serves one track.
void VctInitiator::declare(const PlotWindow& window) {
  // By expectation, then in the order found; std::stable_sort would allocate.
  std::sort(chains_.begin(), chains_.end(), [](const Chain& a, const Chain& b) {
    return a.log_expected != b.log_expected ? a.log_expected < b.log_expected : a.first_plot < b.first_plot;
  });
  used_.assign(static_cast<std::size_t>(window.num_plots()), 0);
  for (const Chain& chain : chains_) {
    const auto is_used = [&](int plot) { return used_[static_cast<std::size_t>(plot)] != 0; };
    const std::span<const int> plots = plots_of(chain);
    if (std::ranges::any_of(plots, is_used)) continue;
    for (const int plot : plots) used_[static_cast<std::size_t>(plot)] = 1;
    add_track(window, plots, motion_, -chain.log_expected, started_, chain.turn_rate);
  }
  started_.survivors = started_.plots;
}

std::unique_ptr<Initiator> make_vct(const InitiatorConfig& config) {
  config.validate();
  chosen_variant(config, "vct", {});
  VctParams params;
  params.speeds = speed_limits(config, params.speeds);
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(params.motion.acceleration_sigma);
  params.window_scans =
      config.window_scans.value_or(std::max(params.window_scans, config.min_plots.value_or(0)));
  params.min_plots = config.min_plots.value_or(params.window_scans);
  params.gate_probability = config.gate_probability.value_or(params.gate_probability);
  params.max_false_tracks = config.max_false_tracks.value_or(params.max_false_tracks);
  params.clutter_per_area = config.clutter_per_area;
  params.max_turn_rate = config.max_turn_rate.value_or(params.max_turn_rate);
  return std::make_unique<VctInitiator>(params);
}

}  // namespace lookout::tracking
