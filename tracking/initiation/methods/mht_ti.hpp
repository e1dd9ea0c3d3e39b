// Source: modified Hough transform from temporary tracks, MHT-TI, as described by [Fan2018] section III.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/line_voting.hpp"
#include "tracking/initiation/lines/pair_points.hpp"

namespace lookout::tracking {

/// Votes in pairs: every two plots of consecutive scans form a temporary track and vote once, for the line
/// through both; no plot votes alone, unlike in the standard transform (HtInitiator). Pairs that the speed
/// limits refuse do not vote: without limits this is MHT-TI, with limits IHT-TI. A peak needs two votes: one
/// pair alone is no line. Cost: pairs. Refuses windows of more than `kMaxPairs` pairs.
class PairVotingInitiator : public HoughInitiator {
 public:
  static constexpr std::int64_t kMaxPairs = 2'000'000;  ///< About 200 MB and a second.

  /// @throws std::invalid_argument on a value out of range.
  PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  const LineGrid& grid() const override { return grid_; }
  void append_cells(std::vector<LineVote>& cells) const override;

 private:
  bool vote(const PlotWindow& window);

  LineVotingParams params_;
  PairFormation formation_;
  LineGrid grid_;
  SparseAccumulator votes_;
  std::vector<PairPoint> pairs_;
  std::vector<LineVote> candidates_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kMhtTiKeys{
    "rho_step",  "theta_step_deg", "rho_tolerance", "theta_tolerance_deg", "peak_threshold",
    "min_plots", "max_tracks",     "window_scans",  "acceleration_sigma"};

/// Keys: those of LineVotingParams. No variants.
std::unique_ptr<Initiator> make_mht_ti(const InitiatorConfig& config);

}  // namespace lookout::tracking
