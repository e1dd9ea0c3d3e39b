// Source: modified Hough transform from temporary tracks, MHT-TI, as described by [Fan2018] section III.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/line_track.hpp"
#include "tracking/initiation/lines/line_voting.hpp"
#include "tracking/initiation/lines/pair_points.hpp"

namespace lookout::tracking {

/// Votes in pairs: every two plots of consecutive scans form a temporary track and vote once, for the line
/// through both; no plot votes alone, unlike in the standard transform (HtInitiator). Pairs that the speed
/// limits refuse do not vote: without limits this is MHT-TI, with limits IHT-TI. A peak needs two votes: one
/// pair alone is no line. Cost: pairs. Refuses windows of more than `kMaxPairs` pairs. NhtTiInitiator weighs
/// the votes of the same pairs.
class PairVotingInitiator : public HoughInitiator {
 public:
  static constexpr std::int64_t kMaxPairs = 2'000'000;  ///< About 200 MB and a second.

  /// @throws std::invalid_argument on a value out of range.
  PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  const LineGrid& grid() const override { return grid_; }
  void append_cells(std::vector<LineVote>& cells) const override;

 protected:
  /// @param max_pairs most of a window that are looked at. @throws std::invalid_argument on a value out of
  /// range.
  PairVotingInitiator(const LineVotingParams& params, const SpeedLimits& speeds, std::int64_t max_pairs);

  virtual void begin_window() {}  ///< Before the first step of a window.
  /// The pairs of one step vote, each by `vote`.
  virtual void take_step(const std::vector<PairPoint>& step);
  /// Adds a vote for a cell on the grid.
  void vote(const LineCell& cell, double weight) { votes_.add(grid_.index(cell), weight); }
  /// Notes a pair as one that chooses the plots of a line, as strongly as its weight.
  void note_voter(const PairPoint& pair) { voters_.push_back(pair); }

  LineGrid grid_;  ///< Over the window at hand.

 private:
  bool take_steps(const PlotWindow& window);
  void declare(const PlotWindow& window);

  LineVotingParams params_;
  PairFormation formation_;
  SparseAccumulator votes_;
  std::vector<PairPoint> voters_;
  std::vector<LineVote> candidates_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// Keys: kLineVotingKeys. No variants.
std::unique_ptr<Initiator> make_mht_ti(const InitiatorConfig& config);

}  // namespace lookout::tracking
