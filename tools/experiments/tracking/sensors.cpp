#include "tools/experiments/tracking/sensors.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/random.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/thread_time.hpp"
#include "tools/experiments/harness/quantiles.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/perfect_association.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/intake/several_returns.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/track_quality.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

/// A sensor, by the name of its scene, and what counts as a miss there [m]: OSPA's cut-off, and how far a
/// track may be from its target.
struct Sensor {
  const char* name;
  double cutoff;
};
constexpr std::array kSensors{Sensor{"close", 0.5},    Sensor{"fine", 2.0},      Sensor{"wide", 2.0},
                              Sensor{"turn_6s", 10.0}, Sensor{"turn_20s", 10.0}, Sensor{"turn_48s", 10.0},
                              Sensor{"radar", 40.0},   Sensor{"ring", 20.0},     Sensor{"echoes", 20.0},
                              Sensor{"tenfold", 20.0}, Sensor{"arc", 20.0},      Sensor{"flood", 5.0},
                              Sensor{"two", 20.0}};
constexpr std::array kMissProbabilities{0.1, 0.3};
constexpr std::array kFigures{"unknown", "known"};
constexpr int kRivalRuns = 5;
constexpr double kHighQuantile = 0.99;  // Of the processor times of a run's scans.
constexpr double kTurn =
    core::radians(10.0);  // The targets of a run are turned about the sensor by up to this.
/// Keeps the draws of a run's turn apart from the trackers' seeds.
constexpr std::uint64_t kTurnDraws = std::uint64_t{1} << 41;

Cell make_cell(const char* sensor, const std::string& method, double p_miss, const char* figures) {
  Cell cell;
  cell.method = method;
  cell.parameters = {
      {"sensor", std::string(sensor)}, {"p_miss", p_miss}, {"sensor_figures", std::string(figures)}};
  if (method != "joint") cell.max_runs = kRivalRuns;
  return cell;
}

double cutoff_of(const Cell& cell) {
  const std::string name = cell.parameters.text("sensor");
  return std::find_if(kSensors.begin(), kSensors.end(), [&](const Sensor& s) { return name == s.name; })
      ->cutoff;
}

/// The scene of a sensor with the targets of a run: where a target lies within its beam decides the error of
/// its bearing, so that runs of one place would repeat it.
sonar_sim::Scene scene_of(const Cell& cell, std::uint64_t seed, int run) {
  auto scene = sonar_sim::load_scene(tools_directory() + "/scenarios/sensor_" +
                                     cell.parameters.text("sensor") + ".yaml");
  auto& platform = scene.platforms.front();
  platform.sonar.params.miss_probability = cell.parameters.number("p_miss");
  for (auto& sonar : platform.further_sonars)
    sonar.params.miss_probability = cell.parameters.number("p_miss");
  core::Random random(seed, core::RandomStream::experiment, kTurnDraws | static_cast<std::uint64_t>(run));
  const Eigen::Rotation2Dd turn(random.uniform(-kTurn, kTurn));
  for (auto& target : scene.targets) {
    target.position = turn * target.position;
    target.velocity = turn * target.velocity;
  }
  return scene;
}

/// What the tracker is told: geometry, accuracy, period and fastest target, and the probabilities or not.
/// That a sensor has no beams is said by its clutter, so that this is told too.
core::SonarParams told(const Cell& cell, const sonar_sim::Scene& scene) {
  core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms.front());
  if (cell.parameters.text("sensor_figures") == "known") return sonar;
  sonar.miss_probability.reset();
  sonar.false_alarm_probability.reset();
  return sonar;
}

/// Takes the scans of a run one after the other and scores each.
class SensorRun {
 public:
  SensorRun(double cutoff, const core::SonarParams& truly)
      : scorer_({.cutoff = cutoff}, tracking::TruthKind::visible),
        quality_({.gate = cutoff}),
        reference_(truly),
        period_ms_(1e3 * truly.scan_period) {}

  void add(const TimedScan& scan, std::span<const core::Track> tracks, double time_ms) {
    scorer_.add(scan.truth, tracks);
    quality_.add(scan.truth, tracks);
    times_ms_.push_back(time_ms);
    compare(reference_.update(scan));
  }

  Metrics metrics() const {
    const auto followed = quality_.result();
    const double median_ms = median(times_ms_);
    return {{"ospa", scorer_.mean().position.total},
            {"error", std::sqrt(error_ / pairs_)},
            {"least_squares", std::sqrt(least_ / pairs_)},
            {"followed_share", followed.followed_share},
            {"identities", followed.identities},
            {"num_tracks", followed.mean_tracks},
            {"false_per_100s", followed.false_per_100s},
            {"time_to_confirm_s", followed.time_to_confirm},
            {"time_ms_median", median_ms},
            {"time_ms_p99", quantile(times_ms_, kHighQuantile)},
            {"share_of_real_time", median_ms / period_ms_}};
  }

 private:
  /// Where a track is on a target, its error and that of least squares.
  void compare(const std::vector<core::Track>& fits) {
    for (const auto& [target, track] : quality_.pairs()) {
      const auto fit = std::find_if(fits.begin(), fits.end(),
                                    [&, id = target.id](const core::Track& f) { return f.id == id; });
      if (fit == fits.end()) continue;
      error_ += (track.state.head<2>() - target.position).squaredNorm();
      least_ += (fit->state.head<2>() - target.position).squaredNorm();
      pairs_ += 1.0;
    }
  }

  tracking::Scorer scorer_;
  tracking::TrackQuality quality_;
  PerfectAssociation reference_;
  double period_ms_;
  std::vector<double> times_ms_;
  double error_ = 0.0, least_ = 0.0, pairs_ = 0.0;  ///< Sums of squares [m^2], and of how many.
};

/// A tracker as the chain has it: where beams turn out to report several returns, it begins anew with what
/// was heard.
class ReturnsFollowed {
 public:
  ReturnsFollowed(std::string method, const core::SonarParams& told, std::uint64_t seed)
      : method_(std::move(method)), told_(told), seed_(seed), pipeline_(pipeline_of(method_, told_, seed_)) {}

  std::span<const core::Track> step(const core::PosedScan& scan) {
    heard_.push_back(scan);
    const auto returns = told_.point_sensor() ? std::nullopt : several_.learn(scan.scan);
    if (returns) begin_anew(*returns);
    return pipeline_->step(scan).tracks;
  }

 private:
  void begin_anew(double clutter_per_scan) {
    told_.false_alarm_probability.reset();
    told_.clutter_per_scan = clutter_per_scan;
    pipeline_ = pipeline_of(method_, told_, seed_);
    for (std::size_t k = 0; k + 1 < heard_.size(); ++k) pipeline_->step(heard_[k]);
  }

  std::string method_;
  core::SonarParams told_;
  std::uint64_t seed_;
  std::unique_ptr<tracking::ScanPipeline> pipeline_;
  tracking::SeveralReturns several_;
  std::vector<core::PosedScan> heard_;
};

class Sensors : public Experiment {
 public:
  std::string summary() const override {
    return "Trackers on sensors from 5 m at 20 Hz to 500 m at a turn a minute, against least squares that "
           "is told what is whose";
  }
  std::string scenario() const override { return "tools/scenarios/sensor_SENSOR.yaml, turned by run"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const char* figures : kFigures)
      for (const Sensor& sensor : kSensors)
        for (const double p_miss : kMissProbabilities)
          for (const auto& method : tracking::tracker_names())
            cells.push_back(make_cell(sensor.name, method, p_miss, figures));
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto scene = scene_of(cell, seed, run);
    ReturnsFollowed tracker(cell.method, told(cell, scene), run_seed(seed, run));
    SensorRun scored(cutoff_of(cell), scene.platforms.front().sonar.params);
    for (const TimedScan& scan : simulate_through_intake(scene, seed, run)) {
      const double start_ms = thread_time_ms();
      const auto tracks = tracker.step(scan.posed);
      const double spent_ms = thread_time_ms() - start_ms;
      scored.add(scan, tracks, spent_ms);
    }
    return scored.metrics();
  }

  Pooling pooling(const std::string& metric) const override {
    return metric == "error" || metric == "least_squares" ? Pooling::root_mean_square : Pooling::mean;
  }

  /// A ratio of roots of mean squares, for single runs divide by small numbers.
  void complete(Estimates& estimates) const override {
    const auto error = estimates.find("error"), least = estimates.find("least_squares");
    if (error == estimates.end() || least == estimates.end() || least->second.mean <= 0.0) return;
    const double ratio = error->second.mean / least->second.mean;
    const double relative =
        std::hypot(error->second.ci95 / error->second.mean, least->second.ci95 / least->second.mean);
    estimates["error_over_least"] = {ratio, ratio * relative, error->second.runs};
  }
};

}  // namespace

std::unique_ptr<Experiment> make_sensors() {
  return std::make_unique<Sensors>();
}

}  // namespace lookout::tools
