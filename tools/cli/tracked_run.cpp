#include "tools/cli/tracked_run.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/vote_matrices.hpp"

namespace lookout::tools {
namespace {

/// The truth at `utime` of lists in order of time, or nothing.
const core::GroundTruth* truth_at(const std::vector<core::GroundTruth>& truth, std::int64_t utime) {
  const auto found =
      std::lower_bound(truth.begin(), truth.end(), utime,
                       [](const core::GroundTruth& entry, std::int64_t t) { return entry.utime < t; });
  return found != truth.end() && found->utime == utime ? &*found : nullptr;
}

/// ospa.csv, a row a scan that was tracked and whose truth is known.
void write_ospa(const std::string& path, const TrackedRun& run, tracking::Scorer& scorer) {
  core::CsvWriter csv(path, "time_s,total,localization,cardinality,num_truth,num_tracks");
  for (const auto& list : run.output.tracks) {
    const core::GroundTruth* truth = truth_at(run.recording.truth, list.utime);
    if (truth == nullptr) continue;
    const tracking::OspaResult& ospa = scorer.add(*truth, list.tracks).position;
    csv.number(core::seconds(list.utime))
        .number(ospa.total)
        .number(ospa.localization)
        .number(ospa.cardinality);
    csv.integer(ospa.num_truth).integer(ospa.num_tracks).end_row();
  }
  csv.close();
}

void write_summary(const std::string& path, const TrackedRun& run, const Configuration& configuration,
                   const tracking::Scorer& scorer, const Options& options) {
  const tracking::OspaResult mean = scorer.mean().position;
  nlohmann::ordered_json root{{"scenario", options.inputs[0]},
                              {"seed", options.seed},
                              {"tracker", configuration.tracker.name},
                              {"estimator", configuration.estimator.name},
                              {"scans", run.recording.scans.size()},
                              {"lag_s", core::seconds(configuration.lag)},
                              {"tracked_scans", run.output.tracks.size()},
                              {"rejected_scans", run.counts.rejected()},
                              {"truth", options.truth},
                              {"cutoff", options.cutoff},
                              {"order", options.order}};
  if (scorer.num_scans() > 0)
    root["ospa"] = {
        {"total", mean.total}, {"localization", mean.localization}, {"cardinality", mean.cardinality}};
  std::ofstream file(path);
  file << root.dump(1) << "\n";
  if (!file) throw std::runtime_error(path + ": could not be written");
}

}  // namespace

void keep_in_order(std::vector<core::VehicleState>& vehicle) {
  std::vector<core::VehicleState> kept;
  for (const auto& state : vehicle) {
    if (kept.empty() || state.utime > kept.back().utime) kept.push_back(state);
  }
  vehicle = std::move(kept);
}

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
