// Source: P. V. C. Hough, US patent 3069654, 1962, as the standard HT-TI of [Fan2018] section II.
#include "tracking/initiation/methods/ht.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kMaxCells = 200'000'000;  // 400 MB of votes.
constexpr std::int64_t kMaxVotes = 200'000'000;  // A second or two.
constexpr std::size_t kMaxCandidates = 50'000;   // Bounds the peak search.
constexpr int kMinVotes = 2;                     // One plot alone is no line.

}  // namespace

HtInitiator::HtInitiator(const LineVotingParams& params) : params_(params), grid_(1, 1, 1.0) {
  params.validate();
}

bool HtInitiator::refuse(const PlotWindow& window) {
  if (grid_.num_cells() > kMaxCells)
    started_.refusal = "a grid of " + std::to_string(grid_.num_cells()) + " cells, accepted are " +
                       std::to_string(kMaxCells) + "; use a larger rho_step or theta_step";
  else if (static_cast<std::int64_t>(window.num_plots()) * grid_.num_theta() > kMaxVotes)
    started_.refusal =
        "more than " + std::to_string(kMaxVotes) + " votes; use fewer plots or a larger theta_step";
  return !started_.refusal.empty();
}

const StartedTracks& HtInitiator::start(const PlotWindow& window) {
  started_.clear();
  grid_ = grid_over(window, params_);
  if (refuse(window)) return started_;
  votes_.reset(grid_);
  for (const Plot& plot : window.plots()) voting_.vote(grid_, plot.position, votes_);
  declare(window);
  return started_;
}

/// Cells above the threshold; where a flood of clutter makes them too many, above the next threshold that
/// leaves few enough: the strongest are searched first anyway.
void HtInitiator::collect_candidates() {
  const int most = votes_.most();
  int least = std::max(kMinVotes, static_cast<int>(std::ceil(params_.peak_threshold * most)));
  do {
    candidates_.clear();
    votes_.collect(grid_, least, kMaxCandidates, candidates_);
  } while (candidates_.size() >= kMaxCandidates && ++least <= most);
  std::erase_if(candidates_, [&](const LineVote& c) { return !votes_.is_local_maximum(grid_, c); });
}

void HtInitiator::declare(const PlotWindow& window) {
  collect_candidates();
  for (const LineVote& peak : strongest_peaks(grid_, params_.peaks(), candidates_)) {
    const NormalLine line = grid_.centre(peak.cell);
    const Eigen::Vector2d normal = line.normal();
    builder_.clear();
    for (int i = 0; i < window.num_plots(); ++i) {
      if (std::abs(window.plot(i).position.dot(normal) - line.rho) <= params_.rho_tolerance)
        builder_.add(i, 1.0);
    }
    builder_.build(window, line, params_.min_plots, params_.motion, peak.value, started_);
  }
  started_.survivors = started_.plots;
}

void HtInitiator::append_cells(std::vector<LineVote>& cells) const {
  votes_.collect(grid_, 1, static_cast<std::size_t>(grid_.num_cells()), cells);
}

std::unique_ptr<Initiator> make_ht(const InitiatorConfig& config) {
  chosen_variant(config, "ht", {});
  return std::make_unique<HtInitiator>(line_voting_params(config));
}

}  // namespace lookout::tracking
