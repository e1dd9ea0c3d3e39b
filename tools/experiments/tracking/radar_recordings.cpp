#include "tools/experiments/tracking/radar_recordings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "core/files/recording.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/paths.hpp"
#include "tools/experiments/tracking/boat_score.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

/// A recording and how far a track may be from a boat that it follows [m]: in 17 the two boats are nearer to
/// each other than 20 m most of the time.
struct Scenario {
  int number;
  double gate;
};
constexpr std::array kScenarios{Scenario{2, 20.0}, Scenario{13, 20.0}, Scenario{16, 20.0},
                                Scenario{17, 10.0}};

constexpr const char* kConfiguration = "/data/autoferry_radar.yaml";

std::string data_directory() {
  const char* data = std::getenv("LOOKOUT_DATA");
  return data == nullptr ? std::string() : std::string(data) + "/autoferry";
}

/// What the recordings' sonar.yaml does not say of their radar.
core::SonarParams radar() {
  Options options;
  options.config = tools_directory() + kConfiguration;
  return load_configuration(options).sensor;
}

const Scenario& scenario_of(int number) {
  return *std::find_if(kScenarios.begin(), kScenarios.end(),
                       [&](const Scenario& scenario) { return scenario.number == number; });
}

/// The scans at the poses of vehicle.csv, beside the truth of the same times.
std::vector<TimedScan> timed_scans(const core::Recording& recording) {
  core::PoseHistory history;
  auto state = recording.vehicle.begin();
  auto truth = recording.truth.begin();
  std::vector<TimedScan> scans;
  for (const auto& scan : recording.scans) {
    while (state != recording.vehicle.end() && !history.reaches(scan.utime)) history.add(*state++);
    while (truth != recording.truth.end() && truth->utime < scan.utime) ++truth;
    const auto body = history.at(scan.utime);
    if (!body || truth == recording.truth.end() || truth->utime != scan.utime) continue;
    scans.push_back({{scan, core::compose(*body, scan.T_body_sonar)}, *truth});
  }
  return scans;
}

/// Which scans have a return near the target.
std::vector<char> heard_near_target(const std::vector<TimedScan>& scans, std::int32_t id, double radius) {
  std::vector<char> heard;
  for (const auto& scan : scans) {
    const auto target = std::find_if(scan.truth.targets.begin(), scan.truth.targets.end(),
                                     [&](const auto& candidate) { return candidate.id == id; });
    heard.push_back(target != scan.truth.targets.end() && heard_near(scan.posed, target->position, radius));
  }
  return heard;
}

/// The tracks that a tracker has where it is told to leave out what stands still over ground.
TracksOfScans tracks_of_movers(const Cell& cell, const RadarRecording& recording, std::uint64_t seed) {
  tracking::ChainParams params;
  params.tracker.name = cell.method;
  params.tracker.report_standing = false;
  params.seed = seed;
  return track(*tracking::make_pipeline(params, recording.sonar), recording.scans).tracks;
}

class Recordings : public Experiment {
 public:
  std::string summary() const override {
    return "Radar recordings with two labelled boats (Autoferry): share of time followed, error, identities";
  }
  std::string scenario() const override { return "$LOOKOUT_DATA/autoferry/scenario{2,13,16,17}"; }

  std::string missing_input() const override { return missing_radar_recordings(); }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const auto& scenario : kScenarios) {
      for (const auto& method : tracking::tracker_names()) {
        Cell cell;
        cell.method = method;
        cell.parameters = {{"scenario", static_cast<double>(scenario.number)}};
        if (!draws(method)) cell.max_runs = 1;
        cells.push_back(cell);
      }
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto recording = load_radar_recording(static_cast<int>(cell.parameters.number("scenario")));
    const auto pipeline = pipeline_of(cell.method, recording.sonar, run_seed(seed, run));
    const TrackingOutput output = track(*pipeline, recording.scans);
    const BoatScoreParams params{.gate = recording.gate};
    Metrics metrics = follow_metrics(recording.scans, output.tracks, params);
    metrics["ospa_near"] = ospa_near(recording.scans, output.tracks, params);
    metrics.merge(silences(recording.scans, output.tracks, params));
    if (draws(cell.method)) metrics.merge(joint_metrics(cell, recording, run_seed(seed, run), output.tracks));
    metrics["time_ms"] = output.time_ms;
    return metrics;
  }

 private:
  /// What is asked of `joint` alone: its errors beside those of `kalman`, and its tracks without what stands.
  static Metrics joint_metrics(const Cell& cell, const RadarRecording& recording, std::uint64_t seed,
                               const TracksOfScans& tracks) {
    const BoatScoreParams params{.gate = recording.gate};
    const auto rival = track(*pipeline_of("kalman", recording.sonar, seed), recording.scans).tracks;
    Metrics metrics = excess_errors(recording.scans, tracks, rival, params);
    const Metrics moving = follow_metrics(recording.scans, tracks_of_movers(cell, recording, seed), params);
    metrics["followed_share_moving"] = moving.at("followed_share");
    metrics["mean_tracks_moving"] = moving.at("mean_tracks");
    return metrics;
  }

  /// On a recording the others give the same tracks in every run.
  static bool draws(const std::string& method) { return method == "joint"; }
};

}  // namespace

std::string missing_radar_recordings() {
  if (std::filesystem::is_directory(data_directory())) return {};
  return "the environment variable LOOKOUT_DATA names no folder that holds autoferry/ (see "
         "lookout import autoferry)";
}

std::vector<int> radar_scenarios() {
  std::vector<int> numbers;
  numbers.reserve(kScenarios.size());
  for (const auto& scenario : kScenarios) numbers.push_back(scenario.number);
  return numbers;
}

RadarRecording load_radar_recording(int scenario) {
  const auto recording =
      core::read_recording(data_directory() + "/scenario" + std::to_string(scenario), radar());
  RadarRecording result{timed_scans(recording), recording.params.value_or(radar()),
                        scenario_of(scenario).gate};
  mark_in_sight(result.scans);
  return result;
}

void mark_in_sight(std::vector<TimedScan>& scans, const InSightParams& params) {
  std::map<std::int32_t, std::pair<std::size_t, std::size_t>> in_sight;
  for (const auto& scan : scans) {
    for (const auto& target : scan.truth.targets)
      in_sight[target.id] = {1, 0};  // an empty interval: never in sight
  }
  const auto length = static_cast<std::size_t>(params.stretch_scans);
  for (auto& [id, interval] : in_sight) {
    const auto heard = heard_near_target(scans, id, params.radius);
    bool found = false;
    for (std::size_t first = 0; first + length <= heard.size(); ++first) {
      const auto begin = heard.begin() + static_cast<std::ptrdiff_t>(first);
      if (std::count(begin, begin + params.stretch_scans, 1) < params.min_scans) continue;
      interval = {found ? interval.first : first, first + length - 1};
      found = true;
    }
  }
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (auto& target : scans[k].truth.targets) {
      const auto [first, last] = in_sight[target.id];
      target.visible = first <= k && k <= last;
    }
  }
}

std::unique_ptr<Experiment> make_recordings() {
  return std::make_unique<Recordings>();
}

}  // namespace lookout::tools
