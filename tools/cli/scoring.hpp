#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/cli/options.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/truth_timeline.hpp"

namespace lookout::tools {

/// The scorer that --cutoff, --order and --truth ask for. @throws core::InputError on values out of range.
tracking::Scorer make_scorer(const Options& options);

/// "OSPA 1.80 m (localization 1.14 m, cardinality 1.39 m)".
std::string describe(const tracking::OspaResult& ospa);

/// The times of a truth [us], in order.
std::vector<std::int64_t> times_of(const std::vector<core::GroundTruth>& truth);

/// @throws core::InputError naming `name` (the truth's file) where neither series of times [us] reaches into
/// the other.
void require_one_clock(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& scans,
                       const std::string& name);

/// The truth at the times of scans, whatever clock and rate it was recorded at, and what is to be told of
/// that.
class MatchedTruth {
 public:
  /// Matches as `tracking::choose_match` does. @param scans in order of time [us].
  MatchedTruth(const std::vector<core::GroundTruth>& truth, const std::vector<std::int64_t>& scans);
  MatchedTruth(const std::vector<core::GroundTruth>& truth, tracking::ChosenMatch chosen);

  /// The truth at a scan. Where the truth is on the scans' times, a scan without one is a scan without
  /// targets; where it is not, nothing is known then.
  std::optional<core::GroundTruth> at(std::int64_t utime);

  std::vector<std::string> notes() const;  ///< Lines for a person; of the times asked for so far.

 private:
  tracking::TruthTimeline timeline_;
  bool exact_;
  std::string note_;
  std::int64_t asked_ = 0, absent_ = 0;
};

}  // namespace lookout::tools
