#pragma once

#include <optional>
#include <vector>

#include "sonar_sim/random_streams.hpp"
#include "sonar_sim/sea/sea_plan.hpp"

namespace lookout::sonar_sim {

/// The front door of the real sea, for one sonar: what it does to targets before they echo, what it returns
/// beside them, how strong all of it is, and which scans come to nothing. Each part draws from a stream of
/// its own, so that switching one on leaves the draws of all others as they are.
class Sea {
 public:
  /// @throws std::invalid_argument on a plan out of range.
  Sea(const SeaPlan& plan, const StreamKey& key);

  /// Gives the targets of a ping the miss probability and the range noise that they have in this sea.
  void change_targets(const Ping& ping, const core::GroundTruth& truth, std::vector<BeamTarget>& targets);

  /// Adds to the targets' echoes what else returns the ping.
  void add_returns(const Ping& ping, std::vector<BeamReturn>& heard);

  /// Sets the intensities, where the plan has any.
  void mark(std::vector<BeamReturn>& heard);

  /// What becomes of the scan.
  ScanFate draw_fate();

 private:
  SeaPlan plan_;
  std::optional<Fluctuation> fluctuation_;
  core::Random tails_random_, spill_random_, standing_random_, patches_random_, bottom_random_,
      intensity_random_, loss_random_;
};

}  // namespace lookout::sonar_sim
