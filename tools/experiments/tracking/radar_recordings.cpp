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
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/metrics/track_quality.hpp"
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
std::vector<char> heard_near(const std::vector<TimedScan>& scans, std::int32_t id, double radius) {
  std::vector<char> heard;
  for (const auto& scan : scans) {
    const auto target = std::find_if(scan.truth.targets.begin(), scan.truth.targets.end(),
                                     [&](const auto& candidate) { return candidate.id == id; });
    const auto& returns = scan.posed.scan.returns;
    heard.push_back(target != scan.truth.targets.end() &&
                    std::any_of(returns.begin(), returns.end(), [&](const core::SonarReturn& sonar_return) {
                      const auto p_sonar = core::from_polar(sonar_return.range, sonar_return.bearing);
                      const auto p_earth = core::transform(scan.posed.T_earth_sonar, p_sonar);
                      return (p_earth - target->position).norm() <= radius;
                    }));
  }
  return heard;
}

Metrics metrics_of(const tracking::TrackQualityResult& result) {
  Metrics metrics{{"followed_share", result.followed_share},
                  {"identities", result.identities},
                  {"identity_switches", result.identity_switches},
                  {"mean_tracks", result.mean_tracks}};
  for (const auto& target : result.targets) {
    const std::string suffix = "_target" + std::to_string(target.id);
    metrics["followed_share" + suffix] = target.followed_share();
    metrics["identities" + suffix] = target.identities;
    if (target.median_error) metrics["median_error_m" + suffix] = *target.median_error;
  }
  return metrics;
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
    tracking::TrackQuality quality({.gate = recording.gate});
    for (std::size_t k = 0; k < recording.scans.size(); ++k)
      quality.add(recording.scans[k].truth, output.tracks[k]);
    Metrics metrics = metrics_of(quality.result());
    metrics["time_ms"] = output.time_ms;
    return metrics;
  }

 private:
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
    const auto heard = heard_near(scans, id, params.radius);
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
