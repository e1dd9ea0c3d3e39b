#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/files/recording.hpp"
#include "core/ground_truth.hpp"
#include "core/track.hpp"
#include "tools/cli/options.hpp"
#include "tools/cli/scoring.hpp"

namespace lookout::tools {

/// Truth and tracks at one time.
struct ScoredTime {
  core::GroundTruth truth;
  std::span<const core::Track> tracks;
};

/// Truth and estimates of two files, brought to common times as --times, --time-tolerance and --interpolate
/// ask; else by what the files show (docs/formats/scores.md).
class Comparison {
 public:
  /// Of `inputs`, TRUTH.csv and ESTIMATE.csv. Warns of what the truth's times made necessary.
  /// @throws core::InputError on a file that cannot be read, a tolerance out of range, more than 1,000 rows
  /// of one time and where there is no common time.
  explicit Comparison(const Options& options);

  const std::vector<ScoredTime>& times() const { return scored_; }  ///< In order of time.

 private:
  std::vector<std::int64_t> scan_times(const Options& options) const;
  std::vector<std::int64_t> common_times(const std::vector<std::int64_t>& scans, bool at_estimates) const;
  void fill(const std::vector<std::int64_t>& times, MatchedTruth matched, const Options& options);

  std::vector<core::GroundTruth> truth_;
  std::vector<core::TrackList> lists_;
  std::int64_t tolerance_;
  std::vector<ScoredTime> scored_;
};

}  // namespace lookout::tools
