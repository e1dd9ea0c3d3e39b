#include "tools/cli/metric_scores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/files/csv.hpp"
#include "core/input_error.hpp"
#include "tools/cli/scoring.hpp"
#include "tracking/metrics/ospa2.hpp"
#include "tracking/metrics/trajectory_gospa.hpp"

namespace lookout::tools {
namespace {

/// The default price of a change of track, in cut-offs.
constexpr double kSwitchShare = 0.1;

Score ospa_score(const MatchedLists& lists, const Options& options) {
  tracking::Scorer scorer = make_scorer(options);
  Score score{"OSPA", {}, "total,localization,cardinality,num_truth,num_tracks", {}, 0};
  for (const auto& time : lists.times()) {
    const tracking::OspaResult& ospa = scorer.add(time.truth, time.tracks).position;
    score.rows.push_back(
        {ospa.total, ospa.localization, ospa.cardinality, 1.0 * ospa.num_truth, 1.0 * ospa.num_tracks});
  }
  const tracking::OspaResult mean = scorer.mean().position;
  score.parts = {
      {"total", mean.total}, {"localization", mean.localization}, {"cardinality", mean.cardinality}};
  return score;
}

void require_finite_order(const Options& options) {
  if (std::isinf(options.order))
    throw core::InputError("--order: got inf, expected a finite number for --metric " + options.metric);
}

/// Beyond it the powers of short distances and of the switch penalty are 0 beside that of the cut-off.
constexpr double kHighestTrajectoryOrder = 50.0;

void require_trajectory_order(const Options& options) {
  require_finite_order(options);
  if (options.order > kHighestTrajectoryOrder)
    throw core::InputError("--order: got " + core::shortest(options.order) +
                           ", expected a number from 1 to 50 for --metric tgospa");
}

Score gospa_score(const MatchedLists& lists, const Options& options) {
  require_finite_order(options);
  tracking::Scorer scorer = make_scorer(options);
  Score score{"GOSPA", {}, "total,localization,missed,false,num_missed,num_false", {}, 0};
  for (const auto& time : lists.times()) {
    const tracking::GospaResult& gospa = scorer.add(time.truth, time.tracks).gospa;
    score.rows.push_back({gospa.total, gospa.localization, gospa.missed, gospa.false_tracks,
                          1.0 * gospa.num_missed, 1.0 * gospa.num_false});
  }
  const tracking::GospaResult mean = scorer.mean().gospa;
  score.parts = {{"total", mean.total},
                 {"localization", mean.localization},
                 {"missed", mean.missed},
                 {"false", mean.false_tracks}};
  return score;
}

/// What counts of both files, as trajectories.
struct TrajectoryPair {
  TrajectoryPair(const MatchedLists& lists, tracking::TruthKind kind) {
    for (const auto& time : lists.times()) {
      truth.next_time();
      estimate.next_time();
      for (const auto& target : time.truth.targets)
        if (tracking::counts(target, kind)) truth.add(target.id, target.position);
      for (const auto& track : time.tracks)
        if (tracking::counts(track, kind)) estimate.add(track.id, track.position());
    }
  }
  tracking::TrajectorySet truth, estimate;
};

/// The first time that a window of --window ending at time `last` holds.
std::size_t window_begin(const MatchedLists& lists, std::size_t last, const Options& options) {
  if (!options.window) return 0;
  const std::int64_t begin = lists.times()[last].truth.utime - core::microseconds(*options.window);
  std::size_t first = last;
  while (first > 0 && lists.times()[first - 1].truth.utime > begin) --first;
  return first;
}

Score ospa2_score(const MatchedLists& lists, const Options& options) {
  const tracking::TruthKind kind = make_scorer(options).kind();
  if (options.window && !(*options.window > 0.0 && *options.window <= core::seconds(core::kMaxUtime)))
    throw core::InputError("--window: got " + core::shortest(*options.window) + ", expected seconds > 0");
  const TrajectoryPair pair(lists, kind);
  tracking::Ospa2 ospa2({options.cutoff, options.order});
  Score score{"OSPA(2)", {}, "total,localization,cardinality,num_truth,num_tracks", {}, 0};
  const std::size_t end = lists.times().size();
  const bool each = options.window || !options.over_time.empty();
  std::array<double, 3> sum{};
  for (std::size_t last = each ? 0 : end - 1; last < end; ++last) {
    const auto r = ospa2(pair.truth, pair.estimate, {window_begin(lists, last, options), last});
    score.rows.push_back({r.total, r.localization, r.cardinality, 1.0 * r.num_truth, 1.0 * r.num_tracks});
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += score.rows.back()[i] / static_cast<double>(end);
  }
  // Without a window the last value is that of the whole run.
  if (!options.window) std::copy_n(score.rows.back().begin(), sum.size(), sum.begin());
  score.parts = {{"total", sum[0]}, {"localization", sum[1]}, {"cardinality", sum[2]}};
  return score;
}

tracking::TrajectoryGospaParams trajectory_params(const Options& options) {
  const double penalty = options.switch_penalty.value_or(kSwitchShare * options.cutoff);
  if (!(penalty > 0.0 && std::isfinite(penalty)))
    throw core::InputError("--switch-penalty: got " + core::shortest(penalty) + ", expected a number > 0");
  return {options.cutoff, options.order, penalty};
}

Score tgospa_score(const MatchedLists& lists, const Options& options) {
  require_trajectory_order(options);
  const tracking::TruthKind kind = make_scorer(options).kind();
  const TrajectoryPair pair(lists, kind);
  const tracking::TrajectoryGospa metric(trajectory_params(options));
  Score score{
      "T-GOSPA", {}, "total,localization,missed,false,switches,num_missed,num_false,num_switches", {}, 0};
  try {
    const auto result = metric(pair.truth, pair.estimate);
    for (const auto& step : result.steps)
      score.rows.push_back({metric.total(step), metric.total({.localization = step.localization}),
                            metric.total({.missed = step.missed}),
                            metric.total({.false_tracks = step.false_tracks}),
                            metric.total({.switches = step.switches}), 1.0 * step.missed,
                            1.0 * step.false_tracks, step.switches});
    score.parts = {{"total", result.total},       {"localization", result.localization},
                   {"missed", result.missed},     {"false", result.false_tracks},
                   {"switches", result.switches}, {kChanges, result.num_switches}};
  } catch (const std::length_error& error) {
    throw core::InputError(std::string("--metric tgospa: ") + error.what() +
                           ": too many for the exact metric; expected " +
                           "fewer targets or tracks near one another, or a smaller --cutoff");
  }
  return score;
}

constexpr std::array<Metric, 4> kMetrics{{{"ospa", ospa_score},
                                          {"gospa", gospa_score},
                                          {"ospa2", ospa2_score, true},
                                          {"tgospa", tgospa_score, true}}};

void refuse_idle_flags(const Options& options) {
  if (options.window && options.metric != "ospa2")
    throw core::InputError("--window: has no effect on --metric " + options.metric + ", expected ospa2");
  if (options.switch_penalty && options.metric != "tgospa")
    throw core::InputError("--switch-penalty: has no effect on --metric " + options.metric +
                           ", expected tgospa");
}

}  // namespace

const Metric& metric_of(const Options& options) {
  std::string accepted;
  for (const Metric& metric : kMetrics) {
    if (options.metric == metric.name) return refuse_idle_flags(options), metric;
    accepted += std::string(" ") + metric.name;
  }
  throw core::InputError("--metric: got `" + options.metric + "`, expected one of:" + accepted);
}

}  // namespace lookout::tools
