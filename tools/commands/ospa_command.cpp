#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/csv.hpp"
#include "core/input_error.hpp"
#include "core/recording.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// Times that differ by no more than this are one time [us].
constexpr std::int64_t kSameTime = 1;

std::vector<std::int64_t> read_times(const std::string& path) {
  static constexpr std::array<std::string_view, 1> kRequired{"time_s"};
  const core::CsvTable table(path, kRequired);
  std::vector<std::int64_t> times;
  for (std::size_t row = 0; row < table.num_rows(); ++row)
    times.push_back(core::microseconds(table.number(row, "time_s")));
  return times;
}

/// All times of either file, in order, those within a microsecond of one before left out.
std::vector<std::int64_t> distinct(std::vector<std::int64_t> times) {
  std::sort(times.begin(), times.end());
  std::vector<std::int64_t> result;
  for (const auto time : times) {
    if (result.empty() || time - result.back() > kSameTime) result.push_back(time);
  }
  return result;
}

/// The entry at `utime` of lists in order of time, or an empty one.
template <class List>
List at_time(const std::vector<List>& lists, std::int64_t utime) {
  const auto it = std::lower_bound(lists.begin(), lists.end(), utime - kSameTime,
                                   [](const List& list, std::int64_t t) { return list.utime < t; });
  if (it == lists.end() || it->utime > utime + kSameTime) {
    List empty;
    empty.utime = utime;
    return empty;
  }
  return *it;
}

void print_json(const tracking::OspaResult& mean, int times) {
  const nlohmann::ordered_json root{{"total", mean.total},
                                    {"localization", mean.localization},
                                    {"cardinality", mean.cardinality},
                                    {"times", times}};
  std::cout << root.dump() << "\n";
}

}  // namespace

int ospa_command(const Options& options) {
  if (options.inputs.size() != 2) throw core::InputError("ospa: expected TRUTH.csv and ESTIMATE.csv");
  const auto truth = core::read_truth(options.inputs[0]);
  const auto tracks = core::read_tracks(options.inputs[1]);
  std::vector<std::int64_t> times;
  if (!options.times.empty()) {
    times = read_times(options.times);
  } else {
    for (const auto& list : truth) times.push_back(list.utime);
    for (const auto& list : tracks) times.push_back(list.utime);
  }
  times = distinct(std::move(times));
  if (times.empty()) throw core::InputError("ospa: there is no time to average over");

  tracking::Scorer scorer = make_scorer(options);
  for (const auto time : times) scorer.add(at_time(truth, time), at_time(tracks, time).tracks);
  const tracking::OspaResult mean = scorer.mean().position;
  if (options.json) {
    print_json(mean, scorer.num_scans());
  } else {
    std::cout << describe(mean) << " over " << scorer.num_scans() << " times\n";
  }
  return 0;
}

}  // namespace lookout::tools
