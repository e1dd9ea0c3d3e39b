#include "tools/cli/matched_lists.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

/// Times that differ by no more than this are one time, unless --time-tolerance says more [us].
constexpr std::int64_t kSameTime = 1;
/// Points of one time beyond which the assignment takes minutes.
constexpr std::size_t kMostPoints = 1000;
constexpr double kLongestTolerance = 3600.0;  // [s]

using Times = std::vector<std::int64_t>;

Times read_times(const std::string& path) {
  static constexpr std::array<std::string_view, 1> kRequired{"time_s"};
  const core::CsvTable table(path, kRequired);
  Times times;
  for (std::size_t row = 0; row < table.num_rows(); ++row) times.push_back(table.time(row, "time_s"));
  return times;
}

/// In order, those within `tolerance` of one before left out.
Times distinct(Times times, std::int64_t tolerance) {
  std::sort(times.begin(), times.end());
  Times result;
  for (const auto time : times) {
    if (result.empty() || time - result.back() > tolerance) result.push_back(time);
  }
  return result;
}

Times times_of(const std::vector<core::TrackList>& lists) {
  Times times;
  for (const auto& list : lists) times.push_back(list.utime);
  return times;
}

/// The tracks nearest to `utime` of lists in order of time, if within `tolerance`; else none.
std::span<const core::Track> tracks_at(const std::vector<core::TrackList>& lists, std::int64_t utime,
                                       std::int64_t tolerance) {
  auto nearest = std::lower_bound(lists.begin(), lists.end(), utime,
                                  [](const core::TrackList& list, std::int64_t t) { return list.utime < t; });
  if (nearest != lists.begin() &&
      (nearest == lists.end() || utime - std::prev(nearest)->utime < nearest->utime - utime))
    --nearest;
  if (nearest == lists.end() || std::abs(nearest->utime - utime) > tolerance) return {};
  return nearest->tracks;
}

/// What the flags say of times. @throws core::InputError on a tolerance out of range.
std::optional<tracking::TruthMatch> match_of(const Options& options) {
  if (!options.time_tolerance && !options.interpolate) return std::nullopt;
  const double tolerance = options.time_tolerance.value_or(core::seconds(kSameTime));
  if (!(tolerance >= 0.0 && tolerance <= kLongestTolerance))
    throw core::InputError("--time-tolerance: got " + core::shortest(tolerance) + ", expected 0 to 3600 s");
  return tracking::TruthMatch{std::max(kSameTime, core::microseconds(tolerance)), options.interpolate};
}

// The times of --times, or of the recording that the truth belongs to where the estimates are of its scans;
// else none.
Times scan_times(const Options& options, const std::vector<core::TrackList>& lists) {
  if (!options.times.empty()) return read_times(options.times);
  const auto beside = std::filesystem::path(options.inputs[0]).parent_path() / "scans.csv";
  if (!std::filesystem::is_regular_file(beside)) return {};
  const Times scans = distinct(read_times(beside.string()), kSameTime);
  const tracking::TimeAgreement agreement = tracking::compare_times(scans, times_of(lists));
  return agreement.matched == static_cast<std::int64_t>(lists.size()) ? scans : Times{};
}

ComparedLists read_lists(const Options& options) {
  ComparedLists lists{core::read_truth(options.inputs[0]), core::read_tracks(options.inputs[1]), {}};
  lists.scans = scan_times(options, lists.estimates);
  return lists;
}

void require_few(std::size_t points, const std::string& file, std::int64_t utime) {
  if (points > kMostPoints)
    throw core::InputError(file + ": " + std::to_string(points) + " rows at " + core::time_text(utime) +
                           " s, expected at most " + std::to_string(kMostPoints));
}

}  // namespace

MatchedLists::MatchedLists(const Options& options) : MatchedLists(read_lists(options), options) {}

MatchedLists::MatchedLists(ComparedLists lists, const Options& options)
    : truth_(std::move(lists.truth)), lists_(std::move(lists.estimates)), tolerance_(kSameTime) {
  if (!truth_.empty() && !lists_.empty())
    require_one_clock(tools::times_of(truth_), times_of(lists_), options.inputs[0]);
  const auto asked = match_of(options);
  const Times& scans = lists.scans;
  knows_scans_ = !scans.empty();
  if (!scans.empty() && !truth_.empty()) require_one_clock(tools::times_of(truth_), scans, options.inputs[0]);
  auto chosen =
      asked ? tracking::ChosenMatch{*asked, ""}
            : tracking::choose_match(tools::times_of(truth_), scans.empty() ? times_of(lists_) : scans);
  tolerance_ = std::max(tolerance_, chosen.match.tolerance);
  const Times times = common_times(scans, chosen.match.interpolate);
  fill(times, MatchedTruth(truth_, std::move(chosen)), options);
}

// Those of the scans where they are known; else those of the estimates, and of the truth where it is not
// brought to them.
Times MatchedLists::common_times(const Times& scans, bool at_estimates) const {
  if (!scans.empty()) return distinct(scans, tolerance_);
  Times times = times_of(lists_);
  if (!at_estimates) {
    const Times of_truth = tools::times_of(truth_);
    times.insert(times.end(), of_truth.begin(), of_truth.end());
  }
  return distinct(std::move(times), tolerance_);
}

void MatchedLists::fill(const Times& times, MatchedTruth matched, const Options& options) {
  for (const auto time : times) {
    auto truth = matched.at(time);
    if (!truth) continue;
    scored_.push_back({*std::move(truth), tracks_at(lists_, time, tolerance_)});
    scored_.back().truth.utime = time;
    require_few(scored_.back().truth.targets.size(), options.inputs[0], time);
    require_few(scored_.back().tracks.size(), options.inputs[1], time);
  }
  notes_ = matched.notes();
  note_times_without_estimates();
  if (scored_.empty()) throw core::InputError("ospa: there is no time to average over: " + spans());
}

/// A list of estimates does not say which scans showed nothing: truth at a higher rate looks like scans
/// without a track.
void MatchedLists::note_times_without_estimates() {
  const auto without =
      std::count_if(scored_.begin(), scored_.end(), [](const auto& pair) { return pair.tracks.empty(); });
  if (knows_scans_ || 2 * static_cast<std::size_t>(without) < scored_.size()) return;
  notes_.push_back(
      std::to_string(without) + " of " + std::to_string(scored_.size()) +
      " times are of the truth alone: scored as without tracks (--times SCANS.csv names the scans)");
}

/// From when to when truth and estimates go.
std::string MatchedLists::spans() const {
  const auto span = [](const Times& times) {
    return times.empty() ? "nothing"
                         : core::time_text(times.front()) + " to " + core::time_text(times.back()) + " s";
  };
  return "the truth holds " + span(tools::times_of(truth_)) + ", the estimates " + span(times_of(lists_));
}

}  // namespace lookout::tools
