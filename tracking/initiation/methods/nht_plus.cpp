// Source: our own, NHT+: the voting of [Fan2018] with tolerances from the noise and with speed;
// docs/initiators.md.
#include "tracking/initiation/methods/nht_plus.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {
namespace {

constexpr int kMaxColumns = 20'000;
constexpr double kMaxRows = 1e6;

Eigen::Vector2d middle_of(const PlotWindow& window) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (const Plot& plot : window.plots()) sum += plot.position;
  return window.num_plots() > 0 ? Eigen::Vector2d(sum / window.num_plots()) : sum;
}

double sigma_of(const Plot& plot) {
  return std::sqrt(0.5 * plot.noise.trace());
}

/// Median of the plots' standard deviations [m]: a few very accurate plots must not refine the whole grid.
double median_sigma(const PlotWindow& window, std::vector<double>& sigmas) {
  sigmas.clear();
  for (const Plot& plot : window.plots()) sigmas.push_back(sigma_of(plot));
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return *middle;
}

double longest_step(const PlotWindow& window) {
  double longest = 0.0;
  for (int k = 1; k < window.num_scans(); ++k)
    longest = std::max(longest, window.time(k) - window.time(k - 1));
  return longest;
}

}  // namespace

NhtPlusInitiator::NhtPlusInitiator(const NhtPlusParams& params)
    : params_(params), formation_(params.speeds, kMaxPairs, params.gate_margin), grid_(1, 1, 1.0) {
  params.motion.validate();
  if (!std::isfinite(params.speeds.max)) throw std::invalid_argument("max_speed must be finite");
  core::require(params.min_plots >= 3, "min_plots must be >= 3", params.min_plots);
  core::require(params.acceleration_factor >= 1.0, "acceleration_factor must be >= 1",
                params.acceleration_factor);
  core::require_positive("reach_sigmas", params.reach_sigmas);
  core::require_positive("theta_cells_per_sigma", params.theta_cells_per_sigma);
  core::require_positive("rho_cells_per_sigma", params.rho_cells_per_sigma);
  core::require_positive("speed_bin_sigmas", params.speed_bin_sigmas);
  core::require(params.window_scans >= 2, "window_scans must be >= 2", params.window_scans);
  core::require_share("peak_threshold", params.peak_threshold);
  core::require_inner_share("chain_probability", params.chain_probability);
  core::require(params.max_tracks >= 1, "max_tracks must be >= 1", params.max_tracks);
  if (params.motion.acceleration_sigma == 0.0) params_.acceleration_factor = 1.0;
}

const StartedTracks& NhtPlusInitiator::start(const PlotWindow& window) {
  started_.clear();
  cells_.clear();
  strong_.clear();
  pairs_.clear();
  num_peaks_ = 0;
  if (window.num_scans() < 3 || window.num_plots() < 3) return started_;
  prepare(window);
  if (!vote(window)) return started_;
  find_peaks();
  declare(window);
  return started_;
}

/// Lays the grid so fine that the pair of the fastest target, whose direction noise changes least, is
/// resolved.
void NhtPlusInitiator::prepare(const PlotWindow& window) {
  origin_ = middle_of(window);
  double distance = 1.0;
  for (const Plot& plot : window.plots()) distance = std::max(distance, (plot.position - origin_).norm());
  const double sigma = params_.acceleration_factor * median_sigma(window, sigmas_);
  const double theta_sigma = std::numbers::sqrt2 * sigma / (params_.speeds.max * longest_step(window));
  const double rho_step = std::max(sigma / params_.rho_cells_per_sigma, 2.0 * distance / kMaxRows);
  const double theta_step = theta_sigma / params_.theta_cells_per_sigma;
  const double half_rows =
      std::ceil(distance / rho_step) + params_.rho_cells_per_sigma * params_.reach_sigmas + 1.0;
  const double columns = std::clamp(std::ceil(std::numbers::pi / theta_step), 8.0, 1.0 * kMaxColumns);
  grid_ = {static_cast<int>(columns), 2 * static_cast<int>(half_rows), half_rows * rho_step};
  layer_step_ = 0.5 * params_.speed_bin_sigmas * std::numbers::sqrt2 * sigma / longest_step(window);
  max_layer_ = static_cast<int>(std::ceil(params_.speeds.max / layer_step_)) + 1;
  least_peak_ = params_.peak_threshold * (window.num_scans() - 1);
}

NhtPlusInitiator::PairVote NhtPlusInitiator::measured(const PlotWindow& window, const PairPoint& pair) const {
  const Plot& a = window.plot(pair.older);
  const Plot& b = window.plot(pair.newer);
  const Eigen::Vector2d displacement = b.position - a.position;
  const double sigma = params_.acceleration_factor * std::sqrt(0.25 * (a.noise + b.noise).trace());
  return {pair,         0.5 * (a.position + b.position) - origin_,
          displacement, b.time - a.time,
          sigma,        std::min(std::numbers::sqrt2 * sigma / displacement.norm(), std::numbers::pi / 4),
          b.scan};
}

bool NhtPlusInitiator::vote(const PlotWindow& window) {
  formation_.restart();
  for (int scan = 1; scan < window.num_scans() && !formation_.exceeded(); ++scan) {
    for (const PairPoint& pair : formation_.form(window, scan, origin_))
      pairs_.push_back(measured(window, pair));
  }
  if (formation_.exceeded()) started_.refusal = formation_.refusal();
  if (!started_.refusal.empty()) return false;
  sort_by_column();
  for (std::size_t column = 0; column + 1 < first_vote_.size(); ++column) {
    for (std::size_t i = first_vote_[column]; i < first_vote_[column + 1]; ++i)
      vote_column(pairs_[static_cast<std::size_t>(column_votes_[i].pair)], column_votes_[i].column);
    keep_column();
    if (cells_.size() <= kMaxCells) continue;
    started_.refusal =
        "more than " + std::to_string(kMaxCells) + " cells with votes; use vct, or fewer plots";
    return false;
  }
  return true;
}

template <class Visit>
void NhtPlusInitiator::for_each_column(const PairVote& pair, const Visit& visit) const {
  const double reach = params_.reach_sigmas * pair.theta_sigma;
  const int first = static_cast<int>(std::ceil((pair.pair.line.theta - reach) / grid_.theta_step() - 0.5));
  const int last = static_cast<int>(std::floor((pair.pair.line.theta + reach) / grid_.theta_step() - 0.5));
  for (int column = first; column <= last; ++column)
    visit(column, static_cast<std::size_t>(grid_.wrapped({column, 0}).theta));
}

/// A counting sort, which leaves the pairs of one column in order of their step.
void NhtPlusInitiator::sort_by_column() {
  first_vote_.assign(static_cast<std::size_t>(grid_.num_theta()) + 1, 0);
  for (const PairVote& pair : pairs_)
    for_each_column(pair, [&](int, std::size_t wrapped) { ++first_vote_[wrapped + 1]; });
  std::partial_sum(first_vote_.begin(), first_vote_.end(), first_vote_.begin());
  column_votes_.resize(first_vote_.back());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    for_each_column(pairs_[i], [&](int column, std::size_t wrapped) {
      column_votes_[first_vote_[wrapped]++] = {static_cast<int>(i), column};
    });
  }
  // Each entry now tells where its column ends, that is, where the next one begins.
  std::shift_right(first_vote_.begin(), first_vote_.end(), 1);
  first_vote_.front() = 0;
}

/// The lines of one direction near the pair's middle, each at the two speed bins around the pair's speed.
void NhtPlusInitiator::vote_column(const PairVote& pair, int column) {
  const double theta = grid_.theta_of(column);
  const NormalLine through_middle{pair.middle.dot(NormalLine{0.0, theta}.normal()), theta};
  const double turn = (theta - pair.pair.line.theta) / pair.theta_sigma;
  const double rho_sigma = pair.sigma / std::numbers::sqrt2;
  const double speed = pair.displacement.dot(through_middle.direction()) / pair.seconds;
  const int layer = static_cast<int>(std::floor(speed / layer_step_));
  const int first = grid_.row_of(through_middle.rho - params_.reach_sigmas * rho_sigma);
  const int last = grid_.row_of(through_middle.rho + params_.reach_sigmas * rho_sigma);
  for (int row = first; row <= last; ++row) {
    const LineCell cell = grid_.wrapped({column, row});
    if (!grid_.contains(cell)) continue;
    const double shift = (grid_.centre({column, row}).rho - through_middle.rho) / rho_sigma;
    const double weight = std::exp(-0.5 * (turn * turn + shift * shift));
    // Over the end of theta the direction of the line, and with it the sign of the speed, turns about.
    const int sign = cell.theta == column ? 1 : -1;
    column_.raise(key_of(cell, sign * layer), pair.step, weight);
    column_.raise(key_of(cell, sign * (layer + 1)), pair.step, weight);
  }
}

std::int64_t NhtPlusInitiator::key_of(const LineCell& cell, int layer) const {
  return grid_.index(cell) * (2 * max_layer_ + 1) + std::clamp(layer, -max_layer_, max_layer_) + max_layer_;
}

void NhtPlusInitiator::keep_column() {
  const int layers = 2 * max_layer_ + 1;
  for (const auto& entry : column_.entries()) {
    cells_.push_back({grid_.cell_at(entry.key / layers), entry.total(),
                      static_cast<int>(entry.key % layers) - max_layer_});
    if (entry.total() >= least_peak_) strong_.add(entry.key, entry.total());
  }
  column_.clear();
}

/// Votes of a cell above the threshold; 0 of the others, which suppress no peak.
double NhtPlusInitiator::strong_value(const LineCell& cell, int layer) const {
  return grid_.contains(cell) ? strong_.value(key_of(cell, layer)) : 0.0;
}

bool NhtPlusInitiator::is_local_maximum(const LineVote& vote) const {
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const LineCell beside = grid_.wrapped({vote.cell.theta + i, vote.cell.rho + j});
      const bool turned = vote.cell.theta + i != beside.theta;
      if (strong_value(beside, turned ? -vote.layer : vote.layer) > vote.value) return false;
    }
  }
  return true;
}

/// The local maxima above the threshold, no two of them within the reach of one line.
void NhtPlusInitiator::find_peaks() {
  candidates_.clear();
  for (const LineVote& cell : cells_) {
    if (cell.value >= least_peak_ && is_local_maximum(cell)) candidates_.push_back(cell);
  }
  PeakParams peaks;
  peaks.theta_radius = static_cast<int>(std::ceil(params_.theta_cells_per_sigma));
  peaks.rho_radius = static_cast<int>(std::ceil(params_.reach_sigmas * params_.rho_cells_per_sigma));
  peaks.layer_radius = 1;
  peaks.max_peaks = params_.max_tracks;
  num_peaks_ = strongest_peaks(grid_, peaks, candidates_).size();
}

void NhtPlusInitiator::declare(const PlotWindow& window) {
  used_.assign(static_cast<std::size_t>(window.num_plots()), 0);
  for (std::size_t i = 0; i < num_peaks_; ++i) declare_peak(window, candidates_[i]);
  started_.survivors = started_.plots;
}

/// How strongly a pair votes for a line and speed; 0 out of its reach.
double NhtPlusInitiator::agreement(const PairVote& pair, const NormalLine& line, double speed) const {
  const NormalLine apart = line_difference(pair.pair.line, line);
  const double turn = apart.theta / pair.theta_sigma;
  const double shift = line.offset_of(pair.middle) * std::numbers::sqrt2 / pair.sigma;
  const double excess = pair.displacement.dot(line.direction()) / pair.seconds - speed;
  const double reach = params_.reach_sigmas;
  if (std::abs(turn) > reach || std::abs(shift) > reach || std::abs(excess) > 2.0 * layer_step_) return 0.0;
  return std::exp(-0.5 * (turn * turn + shift * shift));
}

void NhtPlusInitiator::declare_peak(const PlotWindow& window, const LineVote& peak) {
  const NormalLine line = grid_.centre(peak.cell);
  builder_.clear();
  for (const PairVote& pair : pairs_) {
    const auto used = [&](int plot) { return used_[static_cast<std::size_t>(plot)] != 0; };
    const double weight = agreement(pair, line, peak.layer * layer_step_);
    if (weight <= 0.0 || used(pair.pair.older) || used(pair.pair.newer)) continue;
    builder_.add(pair.pair.older, weight);
    builder_.add(pair.pair.newer, weight);
  }
  const NormalLine in_window{line.rho + origin_.dot(line.normal()), line.theta};
  if (!builder_.build(window, in_window, params_.min_plots, params_.motion, peak.value, started_)) return;
  const auto chosen = builder_.chosen();
  const TrackFit fit = fit_track(window, chosen, params_.motion);
  if (fit.chi_square > chi_square_gate(params_.chain_probability, 2 * fit.plots - 4)) {
    started_.plots.resize(static_cast<std::size_t>(started_.tracks.back().first_plot));
    started_.tracks.pop_back();
    return;
  }
  for (const int plot : chosen) used_[static_cast<std::size_t>(plot)] = 1;
}

void NhtPlusInitiator::append_cells(std::vector<LineVote>& cells) const {
  cells.insert(cells.end(), cells_.begin(), cells_.end());
}

std::unique_ptr<Initiator> make_nht_plus(const InitiatorConfig& config) {
  config.validate();
  chosen_variant(config, "nht_plus", {});
  NhtPlusParams params;
  params.speeds = speed_limits(config, kFanSpeeds);
  params.motion.acceleration_sigma = config.acceleration_sigma.value_or(0.0);
  params.gate_margin = config.gate_margin.value_or(params.gate_margin);
  params.min_plots = config.min_plots.value_or(params.min_plots);
  params.window_scans = config.window_scans.value_or(params.window_scans);
  params.peak_threshold = config.peak_threshold.value_or(params.peak_threshold);
  params.max_tracks = config.max_tracks.value_or(params.max_tracks);
  return std::make_unique<NhtPlusInitiator>(params);
}

}  // namespace lookout::tracking
