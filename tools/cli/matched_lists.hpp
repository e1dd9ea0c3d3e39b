#pragma once

#include <cstdint>
#include <span>
#include <string>
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

/// Truth, estimates and the times of the scans that both are of.
struct ComparedLists {
  std::vector<core::GroundTruth> truth;    ///< In order of time.
  std::vector<core::TrackList> estimates;  ///< Likewise.
  std::vector<std::int64_t> scans;         ///< Times to average over [us]; empty: all that either has.
};

/// Truth and estimates, brought to common times as --times, --time-tolerance and --interpolate ask; else by
/// what the lists show (docs/formats/scores.md).
class MatchedLists {
 public:
  /// Of lists that are there already; in messages they go by the names in `inputs`.
  /// @throws core::InputError as below.
  MatchedLists(ComparedLists lists, const Options& options);

  /// Of the files `inputs`, TRUTH.csv and ESTIMATE.csv.
  /// @throws core::InputError on a file that cannot be read, a tolerance out of range, more than 1,000 rows
  /// of one time and where there is no common time.
  explicit MatchedLists(const Options& options);

  const std::vector<ScoredTime>& times() const { return scored_; }  ///< In order of time.
  const std::vector<std::string>& notes() const { return notes_; }  ///< Lines for a person; mostly none.

 private:
  std::vector<std::int64_t> common_times(const std::vector<std::int64_t>& scans, bool at_estimates) const;
  void fill(const std::vector<std::int64_t>& times, MatchedTruth matched, const Options& options);
  void note_times_without_estimates();
  std::string spans() const;

  std::vector<core::GroundTruth> truth_;
  std::vector<core::TrackList> lists_;
  std::int64_t tolerance_;
  bool knows_scans_ = false;
  std::vector<ScoredTime> scored_;
  std::vector<std::string> notes_;
};

}  // namespace lookout::tools
