#include "tools/cli/tracked_run.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files/csv.hpp"
#include "core/files/text_file.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/vote_matrices.hpp"

namespace lookout::tools {
namespace {

/// The times at which a run is scored: of all its scans, tracked or refused.
std::vector<core::TrackList> scored_lists(const TrackedRun& run) {
  std::vector<core::TrackList> lists = run.output.tracks;
  std::set<std::int64_t> tracked;
  for (const auto& list : lists) tracked.insert(list.utime);
  for (const auto& scan : run.recording.scans)
    if (!tracked.contains(scan.utime)) lists.push_back({scan.utime, {}});
  std::stable_sort(lists.begin(), lists.end(),
                   [](const auto& a, const auto& b) { return a.utime < b.utime; });
  return lists;
}

/// ospa.csv, a row a scan whose truth is known; a scan that was refused has no tracks.
void write_ospa(const std::string& path, const TrackedRun& run, tracking::Scorer& scorer) {
  const std::vector<core::TrackList> lists = scored_lists(run);
  std::vector<std::int64_t> times;
  for (const auto& list : lists) times.push_back(list.utime);
  MatchedTruth matched(run.recording.truth, times);
  core::CsvWriter csv(path, "time_s,total,localization,cardinality,num_truth,num_tracks");
  for (const auto& list : lists) {
    const auto truth = matched.at(list.utime);
    if (!truth) continue;
    const tracking::OspaResult& ospa = scorer.add(*truth, list.tracks).position;
    csv.time(list.utime).number(ospa.total).number(ospa.localization).number(ospa.cardinality);
    csv.integer(ospa.num_truth).integer(ospa.num_tracks).end_row();
  }
  csv.close();
  for (const auto& note : matched.notes()) log_warning(note);
}

/// What came in and what became of it: scans = tracked + the seven reasons, and so on.
/// Of what seldom comes, where it came.
nlohmann::ordered_json received(const tracking::IntakeCounts& counts) {
  nlohmann::ordered_json all{{"scans", counts.received},
                             {"tracked", counts.accepted},
                             {"no_pose", counts.no_pose},
                             {"damaged", counts.damaged},
                             {"out_of_time", counts.out_of_time},
                             {"frozen", counts.frozen},
                             {"foreign", counts.foreign},
                             {"contradicting", counts.contradicting},
                             {"shed", counts.shed},
                             {"returns", counts.returns},
                             {"returns_silent", counts.silent_returns},
                             {"returns_out_of_bounds", counts.dropped_returns},
                             {"vehicle_states", counts.states},
                             {"vehicle_states_believed", counts.accepted_states},
                             {"vehicle_states_rejected", counts.bad_states}};
  const auto add = [&all](const char* what, std::int64_t count) {
    if (count != 0) all[what] = count;
  };
  add("returns_ringing", counts.ringing_returns);
  add("returns_shed", counts.shed_returns);
  add("returns_behind", counts.returns_behind);
  return all;
}

void write_summary(const std::string& path, const TrackedRun& run, const Configuration& configuration,
                   const tracking::Scorer& scorer, const Options& options) {
  const tracking::OspaResult mean = scorer.mean().position;
  nlohmann::ordered_json root{
      {"scenario", options.inputs[0]},
      {"seed", options.seed},
      {"tracker", configuration.tracker.name},
      {"estimator", configuration.estimator.name},
      {"scans", tracks_images(configuration) ? run.counts.accepted + run.counts.rejected()
                                             : static_cast<std::int64_t>(run.recording.scans.size())},
      {"lag_s", core::seconds(configuration.lag)},
      {"tracked_scans", run.output.tracks.size()},
      {"rejected_scans", run.counts.rejected()},
      {"received", received(run.counts)},
      {"truth", options.truth},
      {"cutoff", options.cutoff},
      {"order",
       std::isinf(options.order) ? nlohmann::ordered_json("inf") : nlohmann::ordered_json(options.order)}};
  if (scorer.num_scans() > 0)
    root["ospa"] = {{"total", mean.total},
                    {"localization", mean.localization},
                    {"cardinality", mean.cardinality},
                    {"times", scorer.num_scans()}};
  core::write_text_file(path, root.dump(1) + "\n");
}

}  // namespace

void write_tracked_run(const std::string& directory, const TrackedRun& run,
                       const Configuration& configuration, const Options& options) {
  core::write_tracks(directory + "/tracks.csv", run.output.tracks);
  core::write_elements(directory + "/elements.csv", run.output.elements);
  if (options.votes_at)
    write_vote_matrices(run.recording, run.recording.params.value_or(configuration.sensor),
                        core::microseconds(*options.votes_at), directory);
  tracking::Scorer scorer = make_scorer(options);
  if (!run.recording.truth.empty()) write_ospa(directory + "/ospa.csv", run, scorer);
  write_summary(directory + "/summary.json", run, configuration, scorer, options);
  std::string line = directory + ": " + describe(run.counts);
  if (scorer.num_scans() > 0) line += ", " + describe(scorer.mean().position) + ", truth " + options.truth;
  log_info(line);
}

}  // namespace lookout::tools
