// Source: P. V. C. Hough, US patent 3069654, 1962, as the standard HT-TI of [Fan2018] section II.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"
#include "tracking/initiation/lines/dense_accumulator.hpp"
#include "tracking/initiation/lines/line_track.hpp"
#include "tracking/initiation/lines/line_voting.hpp"

namespace lookout::tracking {

/// The standard Hough transform: every plot of every scan votes once in every column of a dense grid; time
/// and speed play no part. Cost: plots x columns, and the whole grid once. Refuses windows whose grid or
/// whose votes exceed fixed bounds.
class HtInitiator : public HoughInitiator {
 public:
  /// @throws std::invalid_argument on a value out of range.
  explicit HtInitiator(const LineVotingParams& params);

  const StartedTracks& start(const PlotWindow& window) override;
  int window_scans() const override { return params_.window_scans; }
  const LineGrid& grid() const override { return grid_; }
  void append_cells(std::vector<LineVote>& cells) const override;

 private:
  bool refuse(const PlotWindow& window);
  void collect_candidates();
  void declare(const PlotWindow& window);

  LineVotingParams params_;
  LineGrid grid_;
  DenseAccumulator votes_;
  ColumnVoting voting_;
  std::vector<LineVote> candidates_;
  LineTrackBuilder builder_;
  StartedTracks started_;
};

/// Keys: kLineVotingKeys. No variants.
std::unique_ptr<Initiator> make_ht(const InitiatorConfig& config);

}  // namespace lookout::tracking
