#include "tools/cli/scoring.hpp"

#include <algorithm>
#include <cstdio>

#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

constexpr double kLargestCutoff = 1e9;  // [m], beyond any distance on Earth.
/// More scans than this share of them without a truth is worth a line.
constexpr double kWorthTelling = 0.1;

std::string span_of(const std::vector<std::int64_t>& times) {
  return core::time_text(times.front()) + " to " + core::time_text(times.back()) + " s";
}

}  // namespace

std::vector<std::int64_t> times_of(const std::vector<core::GroundTruth>& truth) {
  std::vector<std::int64_t> times;
  for (const auto& list : truth) times.push_back(list.utime);
  std::sort(times.begin(), times.end());
  return times;
}

void require_one_clock(const std::vector<std::int64_t>& truth, const std::vector<std::int64_t>& scans,
                       const std::string& name) {
  if (!tracking::compare_times(truth, scans).apart) return;
  throw core::InputError(name + ": time_s: the truth is of another time: " + span_of(truth) +
                         ", but what is scored " + span_of(scans) + "; expected one clock for both");
}

MatchedTruth::MatchedTruth(const std::vector<core::GroundTruth>& truth,
                           const std::vector<std::int64_t>& scans)
    : MatchedTruth(truth, tracking::choose_match(times_of(truth), scans)) {}

MatchedTruth::MatchedTruth(const std::vector<core::GroundTruth>& truth, tracking::ChosenMatch chosen)
    : timeline_(truth, chosen.match), exact_(chosen.note.empty()), note_(std::move(chosen.note)) {}

std::optional<core::GroundTruth> MatchedTruth::at(std::int64_t utime) {
  ++asked_;
  auto truth = timeline_.at(utime);
  if (!truth) ++absent_;
  if (!truth && exact_) truth = core::GroundTruth{utime, {}};
  return truth;
}

std::vector<std::string> MatchedTruth::notes() const {
  std::vector<std::string> lines;
  if (!note_.empty()) lines.push_back(note_);
  if (static_cast<double>(absent_) > kWorthTelling * static_cast<double>(asked_))
    lines.push_back(
        std::to_string(absent_) + " of " + std::to_string(asked_) +
        " scans are at times without truth: " + (exact_ ? "scored as without targets" : "not scored"));
  return lines;
}

tracking::Scorer make_scorer(const Options& options) {
  if (!(options.cutoff > 0.0 && options.cutoff <= kLargestCutoff))
    throw core::InputError("--cutoff: got " + core::shortest(options.cutoff) +
                           ", expected a number > 0, at most 1e9");
  if (!(options.order >= 1.0))
    throw core::InputError("--order: got " + core::shortest(options.order) +
                           ", expected a number >= 1, or inf");
  const auto kind = tracking::truth_kind(options.truth);
  if (!kind) throw core::InputError("--truth: got `" + options.truth + "`, expected visible or schedule");
  return tracking::Scorer({options.cutoff, options.order}, *kind);
}

std::string describe(const tracking::OspaResult& ospa) {
  char text[128];
  std::snprintf(text, sizeof text, "OSPA %.3f m (localization %.3f m, cardinality %.3f m)", ospa.total,
                ospa.localization, ospa.cardinality);
  return text;
}

}  // namespace lookout::tools
