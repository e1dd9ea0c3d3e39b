#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"

namespace lookout::tracking {

/// How a truth that was recorded on a clock or at a rate of its own is brought to the times of the tracks.
struct TruthMatch {
  std::int64_t tolerance = 1;  ///< Times that differ by no more are one time [us], >= 0.
  bool interpolate = false;    ///< Between two truths that are no further apart than `kLongestGap`.
};

/// The truth of a run at any time: the list within the tolerance, else, where asked for, one interpolated on
/// straight lines between the lists on either side.
class TruthTimeline {
 public:
  static constexpr std::int64_t kLongestGap =
      10'000'000;  ///< Between two truths to interpolate between [us].

  /// @param truth in any order. @throws std::invalid_argument on a negative tolerance.
  TruthTimeline(std::vector<core::GroundTruth> truth, const TruthMatch& match);

  /// The truth at `utime`, nothing where it is not known then. A target of only one of two lists is there
  /// at the times nearer to that list.
  std::optional<core::GroundTruth> at(std::int64_t utime) const;

  /// The lists as recorded, in order of time.
  const std::vector<core::GroundTruth>& lists() const { return truth_; }

 private:
  std::vector<core::GroundTruth> truth_;
  TruthMatch match_;
};

/// How far two series of times agree.
struct TimeAgreement {
  std::int64_t shared = 0;   ///< Times of the second within the first's span.
  std::int64_t matched = 0;  ///< Of these, within a microsecond of one of the first,
  std::int64_t near = 0;     ///< and within kClockSlack.
  std::int64_t nearest = 0;  ///< Least distance of any two [us]; 0 where either is empty.
  bool apart = false;        ///< Neither series reaches into the other.
};

/// @param truth, others in order of time [us].
TimeAgreement compare_times(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& others);

/// A match that serves truth and scans which do not share their times, and a line that says so.
struct ChosenMatch {
  TruthMatch match;  ///< How to take the truth at the scans.
  std::string note;  ///< Empty where the times agree.
};

/// The match for a truth at `truth` times of scans at `scans` times: exact where most agree, a tolerance
/// where each scan has a truth within kClockSlack, else interpolation.
ChosenMatch choose_match(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& scans);

/// Clocks of one vehicle agree to this, and no target moves far in it [us].
inline constexpr std::int64_t kClockSlack = 10'000;

}  // namespace lookout::tracking
