#include "tools/experiments/tracking/scored_run.hpp"

#include <numeric>

#include "core/random.hpp"
#include "tools/cli/thread_time.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/track_quality.hpp"

namespace lookout::tools {

std::uint64_t run_seed(std::uint64_t seed, int run) {
  return core::Random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run))();
}

std::unique_ptr<tracking::ScanPipeline> pipeline_of(const std::string& tracker,
                                                    const core::SonarParams& sonar, std::uint64_t seed) {
  tracking::ChainParams params;
  params.tracker.name = tracker;
  params.seed = seed;
  return tracking::make_pipeline(params, sonar);
}

TrackingOutput track(tracking::ScanPipeline& pipeline, const std::vector<TimedScan>& scans, double lag_s) {
  TrackingOutput output;
  for (const auto& scan : scans) {
    const double start_ms = thread_time_ms();
    auto tracks = pipeline.step(scan.posed).tracks;
    const std::int64_t asked = scans[output.tracks.size()].truth.utime;
    const bool due = scan.truth.utime - asked >= core::microseconds(lag_s);
    if (due && lag_s > 0.0) tracks = pipeline.retrodict(asked);
    output.times_ms.push_back(thread_time_ms() - start_ms);
    if (due) output.tracks.emplace_back(tracks.begin(), tracks.end());
  }
  const double spent_ms = std::accumulate(output.times_ms.begin(), output.times_ms.end(), 0.0);
  output.time_ms = scans.empty() ? 0.0 : spent_ms / static_cast<double>(scans.size());
  return output;
}

Metrics score(const std::vector<TimedScan>& scans, const TrackingOutput& output) {
  tracking::Scorer visible({}, tracking::TruthKind::visible), schedule({}, tracking::TruthKind::schedule);
  tracking::TrackQuality quality;
  for (std::size_t k = 0; k < output.tracks.size(); ++k) {
    visible.add(scans[k].truth, output.tracks[k]);
    schedule.add(scans[k].truth, output.tracks[k]);
    quality.add(scans[k].truth, output.tracks[k]);
  }
  const auto mean = visible.mean();
  const auto followed = quality.result();
  return {{"ospa", mean.position.total},
          {"ospa_localization", mean.position.localization},
          {"ospa_cardinality", mean.position.cardinality},
          {"velocity_ospa", mean.velocity.total},
          {"ospa_schedule", schedule.mean().position.total},
          {"gospa", mean.gospa.total},
          {"gospa_missed", mean.gospa.missed},
          {"gospa_false", mean.gospa.false_tracks},
          {"purity", followed.purity},
          {"identity_switches", followed.identity_switches},
          {"time_to_confirm_s", followed.time_to_confirm},
          {"false_per_100s", followed.false_per_100s},
          {"count_correct", followed.count_correct},
          {"followed_share", followed.followed_share},
          {"identities", followed.identities},
          {"time_ms", output.time_ms}};
}

}  // namespace lookout::tools
