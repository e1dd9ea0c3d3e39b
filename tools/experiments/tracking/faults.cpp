#include "tools/experiments/tracking/faults.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "core/frames.hpp"
#include "core/input_error.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/intake/ping_checks.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/track_quality.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "tracking_table7.yaml";
constexpr double kSettled = 10.0;      // s: scores are from then on
constexpr double kRecoveryMean = 5.0;  // s over which a recovered tracker is as good as one without fault ...
constexpr double kRecoveryMargin = 2.0;  // m ... but for this.

using Counts = ExpectedCounts (*)(const FaultedRun&);

template <class Content>
std::vector<Content> passed(const FaultedRun& run) {
  std::vector<Content> all;
  for (const auto& message : run.passed)
    if (const auto* content = std::get_if<Content>(&message.content)) all.push_back(*content);
  return all;
}

std::int64_t count_garbage(const FaultedRun& run, Stream stream) {
  return std::count_if(run.passed.begin(), run.passed.end(), [stream](const FaultMessage& message) {
    return message.stream == stream && message.content.index() == 0;
  });
}

bool same_returns(const core::SonarScan& a, const core::SonarScan& b) {
  return std::equal(a.returns.begin(), a.returns.end(), b.returns.begin(), b.returns.end(),
                    [](const core::SonarReturn& x, const core::SonarReturn& y) {
                      return x.bearing == y.bearing && x.range == y.range && x.intensity == y.intensity;
                    });
}

bool same_pose(const core::Pose2& a, const core::Pose2& b) {
  return a.north == b.north && a.east == b.east && a.heading == b.heading;
}

/// The times of the vehicle states that say something: a pose that stands while its vehicle moves does not.
std::vector<std::int64_t> times_of_poses(const FaultedRun& run) {
  std::vector<std::int64_t> times;
  const auto states = passed<core::VehicleState>(run);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool stale = i > 0 && states[i].utime != states[i - 1].utime &&
                       same_pose(states[i].T_earth_body, states[i - 1].T_earth_body);
    if (!stale) times.push_back(states[i].utime);
  }
  std::sort(times.begin(), times.end());
  return times;
}

/// Whether a scan has its pose: states on either side, near enough, and the later one before a scan that
/// shows that the wait for it is over.
bool is_posed(std::int64_t utime, const std::vector<std::int64_t>& poses,
              const std::map<std::int64_t, core::SonarScan>& scans) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), utime);
  if (after == poses.end()) return false;
  if (*after == utime) return true;
  const auto over = scans.upper_bound(utime + tracking::IntakeParams().max_wait);
  if (over != scans.end() && over->first < *after) return false;
  return after != poses.begin() && *after - *std::prev(after) <= core::PoseHistory::kMaxBracket;
}

/// Scans that repeat a time, have no pose, or are the third or later with the same returns.
std::int64_t count_bad_scans(const FaultedRun& run) {
  const auto poses = times_of_poses(run);
  std::map<std::int64_t, core::SonarScan> by_time;
  std::int64_t bad = 0;
  for (const auto& scan : passed<core::SonarScan>(run))
    bad += by_time.emplace(scan.utime, scan).second ? 0 : 1;
  const core::SonarScan* before = nullptr;
  int repeats = 0;
  for (const auto& [utime, scan] : by_time) {
    repeats = before != nullptr && same_returns(scan, *before) ? repeats + 1 : 0;
    before = &scan;
    if (repeats > 1 || !is_posed(utime, poses, by_time)) ++bad;
  }
  return bad;
}

/// What the rules of docs/faults.md say of what the tracker was given.
ExpectedCounts by_rule(const FaultedRun& run) {
  ExpectedCounts counts;
  const auto poses = static_cast<std::int64_t>(times_of_poses(run).size());
  const auto states = static_cast<std::int64_t>(passed<core::VehicleState>(run).size());
  const std::int64_t garbage = count_garbage(run, Stream::scan);
  counts.rejected = garbage + count_garbage(run, Stream::vehicle) + states - poses + count_bad_scans(run);
  // Garbage in place of a scan is also a scan that never came; beside one it is not.
  counts.dropped =
      run.faulted_scans.faults.withheld + run.faulted_scans.faults.changed * (garbage > 0 ? 1 : 0);
  return counts;
}

/// Poses that leap as no vehicle moves are no poses: states that were changed are refused, and the
/// others are held to the rules without them.
ExpectedCounts without_changed_states(const FaultedRun& run) {
  FaultedRun others = run;
  const auto changed = std::erase_if(others.passed, [](const FaultMessage& message) {
    return message.changed && message.stream == Stream::vehicle;
  });
  ExpectedCounts counts = by_rule(others);
  counts.rejected += static_cast<std::int64_t>(changed);
  return counts;
}

/// A slow sonar numbers what it sends: nothing is missing.
ExpectedCounts by_rule_but_numbered(const FaultedRun& run) {
  return {0, by_rule(run).rejected, 0};
}

/// When the delay of 3 s ends, what was sent from 57.5 s on comes behind younger messages: 5 scans too late,
/// 11 states more than a second behind, and the scan of 60 s, whose states on either side are 3 s apart.
ExpectedCounts late(const FaultedRun& /*run*/) {
  return {0, 5 + 11 + 1, 0};
}

/// Those of which more than half of the returns lie outside of beams and range are left out.
ExpectedCounts beside_the_geometry(const FaultedRun& run) {
  std::int64_t outside = 0;
  for (auto scan : passed<core::SonarScan>(run)) {
    const auto all = static_cast<int>(scan.returns.size());
    if (2 * tracking::drop_returns(scan).out_of_bounds > all) ++outside;
  }
  return {0, outside, 0};
}

/// The second sender's are left out from the fourth on: three turns show that there are two. The first three
/// show the mirror image, which tracks may speak against.
ExpectedCounts but_three_of_the_second(const FaultedRun& run) {
  constexpr std::int64_t kTurns = 3;
  const std::int64_t doubted = std::min(run.counts.contradicting, kTurns);
  return {0, run.faulted_scans.faults.added - kTurns + doubted, 0};
}

/// The heading of the second sender's states leaps; two at most come when a vehicle could have turned so far.
ExpectedCounts second_navigation(const FaultedRun& run) {
  constexpr std::int64_t kTurned = 2;
  const std::int64_t added = run.faulted_states.faults.added;
  return {0, std::clamp(run.rejected(), added - kTurned, added), 0};
}

/// From the first changed message to the last, the scans but a few: some are believed before tracks speak
/// against them, and at the end some are still doubted.
ExpectedCounts doubted(const FaultedRun& run) {
  constexpr std::int64_t kBefore = 5, kAfter = 4;
  const auto is_changed = [](const FaultMessage& message) { return message.changed; };
  const auto begin = std::find_if(run.passed.begin(), run.passed.end(), is_changed);
  const auto end = std::find_if(run.passed.rbegin(), run.passed.rend(), is_changed).base();
  const std::int64_t scans =
      std::count_if(begin, end, [](const FaultMessage& message) { return message.stream == Stream::scan; });
  return {0, std::clamp(run.counts.contradicting, scans - kBefore, scans + kAfter), 0};
}

/// There and back: each first scan lacks a state of its clock before it.
ExpectedCounts both_on_new_clocks(const FaultedRun& /*run*/) {
  return {0, 2, 2};
}

/// 30 s ahead is a pause of the sonar, and no state is there yet; then it is back on the clock that it had.
ExpectedCounts scans_ahead(const FaultedRun& run) {
  return {0, run.faulted_scans.faults.changed, 0};
}

ExpectedCounts one_bad_stamp(const FaultedRun& /*run*/) {
  return {0, 1, 0};
}

/// A thousand numbers that never came; coming back is a restart of the sender.
ExpectedCounts jumped(const FaultedRun& /*run*/) {
  return {1000, 0, 0};
}

struct FaultCase {
  const char* name;
  Counts expected;
};

constexpr std::array kCases{FaultCase{"none", by_rule},
                            FaultCase{"scan_off", by_rule},
                            FaultCase{"vehicle_off", by_rule},
                            FaultCase{"all_off", by_rule},
                            FaultCase{"scan_stuck", by_rule},
                            FaultCase{"vehicle_stuck", by_rule},
                            FaultCase{"scan_garbage", by_rule},
                            FaultCase{"vehicle_garbage", by_rule},
                            FaultCase{"scan_scale", beside_the_geometry},
                            FaultCase{"scan_degrees", beside_the_geometry},
                            FaultCase{"scan_mirrored", doubted},
                            FaultCase{"vehicle_scale", without_changed_states},
                            FaultCase{"vehicle_degrees", without_changed_states},
                            FaultCase{"vehicle_mirrored", without_changed_states},
                            FaultCase{"scan_slow", by_rule_but_numbered},
                            FaultCase{"vehicle_slow", by_rule},
                            FaultCase{"scan_delayed", by_rule},
                            FaultCase{"vehicle_delayed", by_rule},
                            FaultCase{"all_delayed", late},
                            FaultCase{"scan_intermittent", by_rule},
                            FaultCase{"vehicle_intermittent", by_rule},
                            FaultCase{"scan_doubled", by_rule},
                            FaultCase{"vehicle_doubled", by_rule},
                            FaultCase{"scan_reordered", by_rule},
                            FaultCase{"vehicle_reordered", by_rule},
                            FaultCase{"scan_lost", by_rule},
                            FaultCase{"vehicle_lost", by_rule},
                            FaultCase{"clock_step", both_on_new_clocks},
                            FaultCase{"scan_clock_step", scans_ahead},
                            FaultCase{"scan_stamp", one_bad_stamp},
                            FaultCase{"scan_clock_drift", by_rule},
                            FaultCase{"clock_drift", by_rule},
                            FaultCase{"sequence_glitch", by_rule},
                            FaultCase{"sequence_jump", jumped},
                            FaultCase{"two_sonars", but_three_of_the_second},
                            FaultCase{"two_navigations", second_navigation},
                            FaultCase{"scan_flood", by_rule},
                            FaultCase{"garbage_flood", by_rule}};

/// OSPA at each scan against the visible truth.
std::vector<double> ospa_of(const FaultedRun& run) {
  tracking::Scorer scorer;
  std::vector<double> ospa;
  for (std::size_t k = 0; k < run.truth.size(); ++k)
    ospa.push_back(scorer.add(run.truth[k], run.tracks[k]).position.total);
  return ospa;
}

double time_of(const FaultedRun& run, std::size_t k) {
  return core::seconds(run.truth[k].utime);
}

/// Mean over the scans of [from, to) [s]; NaN over none.
double mean_over(const FaultedRun& run, const std::vector<double>& ospa, double from, double to) {
  double sum = 0.0;
  int scans = 0;
  for (std::size_t k = 0; k < ospa.size(); ++k) {
    if (time_of(run, k) < from || time_of(run, k) >= to) continue;
    sum += ospa[k];
    ++scans;
  }
  return scans > 0 ? sum / scans : std::numeric_limits<double>::quiet_NaN();
}

/// The fault's first and last moment [s].
std::pair<double, double> span_of(const FaultPlan& plan) {
  double from = std::numeric_limits<double>::infinity(), to = 0.0;
  for (const auto& fault : plan.faults) {
    from = std::min(from, fault.from);
    to = std::max(to, fault.to);
  }
  return {from, to};
}

/// How long after `end` the mean over the next five seconds is that of the run without fault, but for the
/// margin [s]; NaN where it never is.
double recovery_time(const FaultedRun& run, const std::vector<double>& ospa, const std::vector<double>& clean,
                     double end) {
  for (std::size_t k = 0; k < ospa.size(); ++k) {
    const double time = time_of(run, k);
    if (time < end) continue;
    const double later = time + kRecoveryMean;
    if (mean_over(run, ospa, time, later) <= mean_over(run, clean, time, later) + kRecoveryMargin)
      return time - end;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// A tracker that is switched on at `end` [s]: before that nothing reaches it.
FaultedRun switched_on_at(double end, const sonar_sim::Scene& scene, std::uint64_t seed, int run) {
  Fault silence;
  silence.streams = {Stream::scan};
  silence.to = end;
  return run_through({{silence}}, scene, seed, run);
}

tracking::TrackQualityResult quality_of(const FaultedRun& run) {
  tracking::TrackQuality quality;
  for (std::size_t k = 0; k < run.truth.size(); ++k) quality.add(run.truth[k], run.tracks[k]);
  return quality.result();
}

void add_quality(const FaultedRun& run, const FaultedRun& clean, Metrics& metrics) {
  const auto result = quality_of(run), without = quality_of(clean);
  metrics["false_per_100s_without"] = without.false_per_100s;
  metrics["time_to_confirm_without_s"] = without.time_to_confirm;
  metrics["false_per_100s"] = result.false_per_100s;
  metrics["identities"] = result.identities;
  metrics["followed_share"] = result.followed_share;
  metrics["time_to_confirm_s"] = result.time_to_confirm;
}

void add_counts(const std::string& name, const FaultedRun& run, Metrics& metrics) {
  const ExpectedCounts expected = expected_counts(name, run);
  metrics["accepted"] = static_cast<double>(run.counts.accepted);
  metrics["rejected"] = static_cast<double>(run.rejected());
  metrics["dropped"] = static_cast<double>(run.counts.lost);
  metrics["resets"] = static_cast<double>(run.counts.resets);
  metrics["accounted"] = run.accounted() ? 1.0 : 0.0;
  const bool exact = expected.dropped == run.counts.lost && expected.rejected == run.rejected() &&
                     expected.resets == run.counts.resets;
  metrics["counts_exact"] = exact ? 1.0 : 0.0;
}

/// What the table says of a run, beside the run without fault.
Metrics figures(const std::string& name, const FaultPlan& plan, const FaultedRun& run,
                const FaultedRun& clean) {
  const auto ospa = ospa_of(run), without = ospa_of(clean);
  const auto [from, to] = plan.faults.empty() ? std::pair{kSettled, kSettled} : span_of(plan);
  const double end = std::numeric_limits<double>::infinity();
  Metrics metrics{{"ospa", mean_over(run, ospa, kSettled, end)},
                  {"ospa_during", mean_over(run, ospa, from, to)},
                  {"ospa_after", mean_over(run, ospa, to, end)},
                  {"ospa_after_without", mean_over(run, without, to, end)},
                  {"recovery_s", recovery_time(run, ospa, without, to)}};
  add_quality(run, clean, metrics);
  add_counts(name, run, metrics);
  return metrics;
}

class Faults : public Experiment {
 public:
  std::string summary() const override {
    return "Every fault of the link and the sensors: what is counted, what it costs, and when it is over";
  }
  std::string scenario() const override {
    return "tools/scenarios/tracking_table7.yaml through tools/scenarios/faults/FAULT.yaml";
  }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const auto& name : fault_names()) cells.push_back({"joint", {{"fault", name}}, {}});
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    return rehearse(cell.parameters.text("fault"), run_without_fault(seed, run), seed, run, true);
  }
};

}  // namespace

FaultedRun run_without_fault(std::uint64_t seed, int run) {
  return run_through({}, load_variant(kScene, {}), seed, run);
}

Metrics rehearse(const std::string& fault, const FaultedRun& clean, std::uint64_t seed, int run,
                 bool with_fresh) {
  const sonar_sim::Scene scene = load_variant(kScene, {});
  if (fault == "none") return figures(fault, {}, clean, clean);
  const FaultPlan plan = shipped_plan(fault);
  Metrics metrics = figures(fault, plan, run_through(plan, scene, seed, run), clean);
  if (!with_fresh) return metrics;
  const double end = span_of(plan).second;
  const FaultedRun fresh = switched_on_at(end, scene, seed, run);
  metrics["fresh_s"] = recovery_time(fresh, ospa_of(fresh), ospa_of(clean), end);
  return metrics;
}

std::vector<std::string> fault_names() {
  std::vector<std::string> names;
  names.reserve(kCases.size());
  for (const auto& fault : kCases) names.emplace_back(fault.name);
  return names;
}

ExpectedCounts expected_counts(const std::string& name, const FaultedRun& run) {
  for (const auto& fault : kCases)
    if (name == fault.name) return fault.expected(run);
  throw core::InputError("fault `" + name + "` is not among the shipped plans");
}

std::unique_ptr<Experiment> make_faults() {
  return std::make_unique<Faults>();
}

}  // namespace lookout::tools
