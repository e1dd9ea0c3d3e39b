#include "tools/experiments/initiation/recording_births.hpp"

#include "tools/experiments/tracking/radar_recordings.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/metrics/track_quality.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

/// The plainest tracker: it follows what was begun, right or wrong.
constexpr const char* kTracker = "gnn";

class RecordingBirths : public Experiment {
 public:
  std::string summary() const override {
    return "The radar recordings with tracks begun by every initiator, followed by one tracker (Autoferry)";
  }
  std::string scenario() const override { return "$LOOKOUT_DATA/autoferry/scenario{2,13,16,17}"; }
  std::string missing_input() const override { return missing_radar_recordings(); }

  std::vector<Cell> cells() const override {
    std::vector<std::string> methods{kTracker};
    for (const auto& name : tracking::initiator_names()) methods.push_back(name);
    std::vector<Cell> cells;
    for (const int scenario : radar_scenarios()) {
      for (const auto& method : methods) {
        cells.push_back({method, {{"scenario", static_cast<double>(scenario)}}, {}});
        cells.back().max_runs = 1;  // Nothing is drawn.
      }
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto recording = load_radar_recording(static_cast<int>(cell.parameters.number("scenario")));
    tracking::ChainParams params;
    params.tracker.name = kTracker;
    params.tracker.initiator = cell.method;
    params.seed = run_seed(seed, run);
    const auto pipeline = tracking::make_pipeline(params, recording.sonar);
    const TrackingOutput output = track(*pipeline, recording.scans);
    tracking::TrackQuality quality({.gate = recording.gate});
    for (std::size_t k = 0; k < recording.scans.size(); ++k)
      quality.add(recording.scans[k].truth, output.tracks[k]);
    return metrics_of(quality.result(), output.time_ms);
  }

 private:
  static Metrics metrics_of(const tracking::TrackQualityResult& result, double time_ms) {
    return {{"time_to_confirm_s", result.time_to_confirm}, {"followed_share", result.followed_share},
            {"false_per_100s", result.false_per_100s},     {"identities", result.identities},
            {"mean_tracks", result.mean_tracks},           {"time_ms", time_ms}};
  }
};

}  // namespace

std::unique_ptr<Experiment> make_recording_births() {
  return std::make_unique<RecordingBirths>();
}

}  // namespace lookout::tools
