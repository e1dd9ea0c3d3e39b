#include "tools/experiments/tracking/over_time.hpp"

#include <cmath>

#include "core/files/csv.hpp"
#include "tools/experiments/harness/monte_carlo.hpp"
#include "tracking/metrics/scorer.hpp"

namespace lookout::tools {
namespace {

/// Mean and interval of one figure at one scan over the runs.
template <typename Figure>
Estimate over_runs(const std::vector<ScoredScans>& runs, std::size_t scan, Figure figure) {
  std::vector<Metric> values;
  for (const auto& run : runs) values.emplace_back(static_cast<double>(run[scan].*figure));
  return pool(values, Pooling::mean);
}

void write_estimate(core::CsvWriter& csv, const Estimate& estimate) {
  csv.number(estimate.mean);
  std::isfinite(estimate.ci95) ? csv.number(estimate.ci95) : csv.blank();
}

}  // namespace

ScoredScans score_scans(const std::vector<TimedScan>& scans, const TrackingOutput& output) {
  tracking::Scorer scorer;
  ScoredScans scored;
  for (std::size_t k = 0; k < output.tracks.size(); ++k) {
    const auto& score = scorer.add(scans[k].truth, output.tracks[k]).position;
    scored.push_back({scans[k].truth.utime, score.total, score.localization, score.cardinality,
                      score.num_truth, score.num_tracks});
  }
  return scored;
}

void write_mean_over_time(const std::vector<ScoredScans>& runs, const std::string& path) {
  core::CsvWriter csv(path,
                      "time_s,total,total_ci95,localization,localization_ci95,cardinality,cardinality_ci95,"
                      "num_truth,num_tracks");
  for (std::size_t scan = 0; scan < runs.front().size(); ++scan) {
    csv.time(runs.front()[scan].utime);
    write_estimate(csv, over_runs(runs, scan, &ScoredScan::total));
    write_estimate(csv, over_runs(runs, scan, &ScoredScan::localization));
    write_estimate(csv, over_runs(runs, scan, &ScoredScan::cardinality));
    csv.number(over_runs(runs, scan, &ScoredScan::num_truth).mean);
    csv.number(over_runs(runs, scan, &ScoredScan::num_tracks).mean).end_row();
  }
  csv.close();
}

}  // namespace lookout::tools
