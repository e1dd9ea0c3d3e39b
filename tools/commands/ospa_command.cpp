// lookout ospa: TRUTH.csv, ESTIMATE.csv (or two directories of them) -> times -> one of four metrics -> a
// line, or JSON, and a CSV over time
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files/csv.hpp"
#include "core/files/recording.hpp"
#include "core/files/time_text.hpp"
#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/metrics/ospa2.hpp"
#include "tracking/metrics/trajectory_gospa.hpp"

namespace lookout::tools {
namespace {

/// Times that differ by no more than this are one time, unless --time-tolerance says more [us].
constexpr std::int64_t kSameTime = 1;
/// Points of one time beyond which the assignment takes minutes.
constexpr std::size_t kMostPoints = 1000;
constexpr double kLongestTolerance = 3600.0;  // [s]
/// The default price of a change of track, in cut-offs.
constexpr double kSwitchShare = 0.1;
/// The one part that is a count.
constexpr const char* kChanges = "num_switches";

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

/// Truth and tracks at one time.
struct ScoredTime {
  core::GroundTruth truth;
  std::span<const core::Track> tracks;
};

/// The two files, brought to common times.
class Comparison {
 public:
  explicit Comparison(const Options& options)
      : truth_(core::read_truth(options.inputs[0])), lists_(core::read_tracks(options.inputs[1])) {
    if (!truth_.empty() && !lists_.empty())
      require_one_clock(tools::times_of(truth_), times_of(lists_), options.inputs[0]);
    const auto asked = match_of(options);
    tolerance_ = asked ? asked->tolerance : kSameTime;
    const Times scans = scan_times(options);
    const Times& others = scans.empty() ? times_of(lists_) : scans;
    auto chosen =
        asked ? tracking::ChosenMatch{*asked, ""} : tracking::choose_match(tools::times_of(truth_), others);
    if (!asked) tolerance_ = std::max(tolerance_, chosen.match.tolerance);
    if (chosen.match.interpolate || !scans.empty())
      times_ = distinct(others, tolerance_);
    else
      times_ = distinct(joined(tools::times_of(truth_), others), tolerance_);
    fill(MatchedTruth(truth_, std::move(chosen)), options);
  }

  const std::vector<ScoredTime>& times() const { return scored_; }

 private:
  static Times joined(Times a, const Times& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// The times of --times, or of the recording that the truth belongs to where the estimates are of its
  /// scans.
  Times scan_times(const Options& options) const {
    if (!options.times.empty()) return read_times(options.times);
    const auto beside = std::filesystem::path(options.inputs[0]).parent_path() / "scans.csv";
    if (!std::filesystem::is_regular_file(beside)) return {};
    const Times scans = distinct(read_times(beside.string()), kSameTime);
    const tracking::TimeAgreement agreement = tracking::compare_times(scans, times_of(lists_));
    if (agreement.matched != static_cast<std::int64_t>(lists_.size())) return {};
    return scans;
  }

  void fill(MatchedTruth matched, const Options& options) {
    for (const auto time : times_) {
      auto truth = matched.at(time);
      if (!truth) continue;
      scored_.push_back({*std::move(truth), tracks_at(lists_, time, tolerance_)});
      scored_.back().truth.utime = time;
      require_few(scored_.back().truth.targets.size(), options.inputs[0], time);
      require_few(scored_.back().tracks.size(), options.inputs[1], time);
    }
    for (const auto& note : matched.notes()) log_warning("ospa: " + note);
    if (scored_.empty()) throw core::InputError("ospa: there is no time to average over");
  }

  static void require_few(std::size_t points, const std::string& file, std::int64_t utime) {
    if (points > kMostPoints)
      throw core::InputError(file + ": " + std::to_string(points) + " rows at " + core::time_text(utime) +
                             " s, expected at most " + std::to_string(kMostPoints));
  }

  std::vector<core::GroundTruth> truth_;
  std::vector<core::TrackList> lists_;
  std::int64_t tolerance_ = kSameTime;
  Times times_;
  std::vector<ScoredTime> scored_;
};

/// What a metric says: the parts by name, and the same at each time.
struct Score {
  std::string name;                                   ///< As in "OSPA 1.8 m".
  std::vector<std::pair<std::string, double>> parts;  ///< The total first.
  std::string header;                                 ///< Of the CSV over time.
  std::vector<std::vector<double>> rows;              ///< One a time.
  std::size_t times = 0;                              ///< That were averaged over.
};

Score ospa_score(const Comparison& comparison, const Options& options) {
  tracking::Scorer scorer = make_scorer(options);
  Score score{"OSPA", {}, "total,localization,cardinality,num_truth,num_tracks", {}, 0};
  for (const auto& time : comparison.times()) {
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

Score gospa_score(const Comparison& comparison, const Options& options) {
  require_finite_order(options);
  tracking::Scorer scorer = make_scorer(options);
  Score score{"GOSPA", {}, "total,localization,missed,false,num_missed,num_false", {}, 0};
  for (const auto& time : comparison.times()) {
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
  TrajectoryPair(const Comparison& comparison, tracking::TruthKind kind) {
    for (const auto& time : comparison.times()) {
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
std::size_t window_begin(const Comparison& comparison, std::size_t last, const Options& options) {
  if (!options.window) return 0;
  const std::int64_t begin = comparison.times()[last].truth.utime - core::microseconds(*options.window);
  std::size_t first = last;
  while (first > 0 && comparison.times()[first - 1].truth.utime > begin) --first;
  return first;
}

Score ospa2_score(const Comparison& comparison, const Options& options) {
  const tracking::TruthKind kind = make_scorer(options).kind();
  if (options.window && !(*options.window > 0.0 && *options.window <= core::seconds(core::kMaxUtime)))
    throw core::InputError("--window: got " + core::shortest(*options.window) + ", expected seconds > 0");
  const TrajectoryPair pair(comparison, kind);
  tracking::Ospa2 ospa2({options.cutoff, options.order});
  Score score{"OSPA(2)", {}, "total,localization,cardinality,num_truth,num_tracks", {}, 0};
  const std::size_t end = comparison.times().size();
  const bool each = options.window || !options.over_time.empty();
  std::array<double, 3> sum{};
  for (std::size_t last = each ? 0 : end - 1; last < end; ++last) {
    const auto r = ospa2(pair.truth, pair.estimate, {window_begin(comparison, last, options), last});
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

Score tgospa_score(const Comparison& comparison, const Options& options) {
  require_finite_order(options);
  const tracking::TruthKind kind = make_scorer(options).kind();
  const TrajectoryPair pair(comparison, kind);
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

struct Metric {
  const char* name;
  Score (*score)(const Comparison&, const Options&);
  bool follows_identities = false;  // From one time to the next.
};

constexpr std::array<Metric, 4> kMetrics{{{"ospa", ospa_score},
                                          {"gospa", gospa_score},
                                          {"ospa2", ospa2_score, true},
                                          {"tgospa", tgospa_score, true}}};

const Metric& metric_of(const Options& options) {
  std::string accepted;
  for (const Metric& metric : kMetrics) {
    if (options.metric == metric.name) return metric;
    accepted += std::string(" ") + metric.name;
  }
  throw core::InputError("--metric: got `" + options.metric + "`, expected one of:" + accepted);
}

void refuse_idle_flags(const Options& options) {
  if (options.window && options.metric != "ospa2")
    throw core::InputError("--window: has no effect on --metric " + options.metric + ", expected ospa2");
  if (options.switch_penalty && options.metric != "tgospa")
    throw core::InputError("--switch-penalty: has no effect on --metric " + options.metric +
                           ", expected tgospa");
}

void write_over_time(const std::string& path, const Score& score, const Comparison& comparison) {
  core::CsvWriter csv(path, "time_s," + score.header);
  for (std::size_t i = 0; i < score.rows.size(); ++i) {
    csv.time(comparison.times()[i].truth.utime);
    for (const double value : score.rows[i]) csv.number(value);
    csv.end_row();
  }
  csv.close();
}

nlohmann::ordered_json to_json(const Score& score) {
  nlohmann::ordered_json root;
  for (const auto& [name, value] : score.parts) root[name] = value;
  root["times"] = score.times;
  return root;
}

std::string in_words(const Score& score) {
  const auto metres = [](double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return std::string(text.data());
  };
  std::string parts;
  for (std::size_t i = 1; i < score.parts.size(); ++i) {
    const auto& [name, value] = score.parts[i];
    const bool count = name == kChanges;
    parts += i > 1 ? ", " : "";
    parts += count ? core::shortest(value) + " changes of track" : name + " " + metres(value) + " m";
  }
  return score.name + " " + metres(score.parts.front().second) + " m (" + parts + ") over " +
         std::to_string(score.times) + " times";
}

/// Tracks over time need identities. @throws core::InputError on a file without them.
void require_identities(const std::string& path) {
  static constexpr std::array<std::string_view, 2> kRequired{"time_s", "id"};
  const core::CsvTable table(path, kRequired);
}

/// One truth and one estimate, scored; also over time where asked.
Score score_pair(const Options& options) {
  const Metric& metric = metric_of(options);
  if (metric.follows_identities)
    for (const auto& file : options.inputs) require_identities(file);
  const Comparison comparison(options);
  Score score = metric.score(comparison, options);
  score.times = comparison.times().size();
  if (!options.over_time.empty()) write_over_time(options.over_time, score, comparison);
  return score;
}

/// The CSV files of a directory by name.
std::set<std::string> csv_files(const std::string& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.is_regular_file() && entry.path().extension() == ".csv")
      names.insert(entry.path().filename().string());
  if (names.empty()) throw core::InputError(directory + ": holds no *.csv, expected a file a run");
  return names;
}

/// The names that both directories have. @throws core::InputError on a file without a partner.
std::set<std::string> pairs_in(const std::string& truth, const std::string& estimate) {
  const std::set<std::string> names = csv_files(truth), others = csv_files(estimate);
  const auto require = [](const std::set<std::string>& own, const std::set<std::string>& other,
                          const std::string& where, const std::string& there) {
    for (const auto& name : own)
      if (!other.contains(name))
        throw core::InputError(where + "/" + name + ": has no partner of that name in " + there);
  };
  require(names, others, truth, estimate);
  require(others, names, estimate, truth);
  return names;
}

/// Means over the pairs, each pair counting alike; the number of times is that of all.
Score mean_of(const std::vector<Score>& scores) {
  Score mean = scores.front();
  for (auto& part : mean.parts) part.second = 0.0;
  mean.times = 0;
  for (const auto& score : scores) {
    for (std::size_t i = 0; i < mean.parts.size(); ++i)
      mean.parts[i].second += score.parts[i].second / static_cast<double>(scores.size());
    mean.times += score.times;
  }
  return mean;
}

/// With two directories --over-time names a directory too, in which each pair has a file.
Options options_of_pair(const Options& options, const std::string& name) {
  Options pair = options;
  for (auto& input : pair.inputs) input += "/" + name;
  if (!options.over_time.empty()) pair.over_time += "/" + name;
  return pair;
}

int score_directories(const Options& options) {
  const auto names = pairs_in(options.inputs[0], options.inputs[1]);
  if (!options.over_time.empty()) make_directory(options.over_time);
  std::vector<Score> scores;
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const auto& name : names) {
    scores.push_back(score_pair(options_of_pair(options, name)));
    nlohmann::ordered_json pair{{"pair", name}};
    pair.update(to_json(scores.back()));
    pairs.push_back(pair);
    if (!options.json) std::cout << name << ": " << in_words(scores.back()) << "\n";
  }
  nlohmann::ordered_json root = to_json(mean_of(scores));
  root["pairs"] = pairs;
  if (options.json)
    std::cout << root.dump() << "\n";
  else
    std::cout << "mean of " << scores.size() << " pairs: " << in_words(mean_of(scores)) << "\n";
  return 0;
}

}  // namespace

int ospa_command(const Options& options) {
  if (options.inputs.size() != 2)
    throw core::InputError("ospa: expected TRUTH.csv and ESTIMATE.csv, or two directories");
  metric_of(options);
  refuse_idle_flags(options);
  make_scorer(options);  // A bad flag stops here, before the work.
  const bool truth = std::filesystem::is_directory(options.inputs[0]);
  if (truth != std::filesystem::is_directory(options.inputs[1]))
    throw core::InputError("ospa: " + options.inputs[truth ? 0 : 1] +
                           " is a directory, the other is none; expected two alike");
  if (truth) return score_directories(options);
  const Score score = score_pair(options);
  std::cout << (options.json ? to_json(score).dump() : in_words(score)) << "\n";
  return 0;
}

}  // namespace lookout::tools
