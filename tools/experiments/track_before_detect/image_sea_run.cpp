#include "tools/experiments/track_before_detect/image_sea_run.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "tools/cli/thread_time.hpp"
#include "tools/experiments/tracking/scored_run.hpp"
#include "tracking/detection_chain.hpp"
#include "tracking/metrics/track_quality.hpp"
#include "tracking/track_before_detect/images/image_chain.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 5> kMethods{"h_pmht", "detect+joint", "detect+csht", "mf_nn",
                                                   "cfar_nn"};
constexpr std::string_view kDetect = "detect+", kHough = "csht";
constexpr double kGate = 5.0;         // m, within which a confirmed track is a target's
constexpr std::size_t kSettled = 20;  // pings, after which false tracks count
constexpr double kDegrees = 4.0;      // of a state
// Half-power extents of a point's echo: of a Gaussian pulse in sigmas, 2 sqrt(ln 2); of a beam in first
// nulls, where sinc(u)^2 and, with a Hann taper, (sinc(2u) / (1 - 4u^2))^2 are one half.
constexpr double kPulseLength = 1.6651, kLineWidth = 0.8859, kTaperedWidth = 0.7203;

using Answers = std::map<std::int64_t, std::vector<core::Track>>;

/// A chain of any kind that takes states and images.
class Road {
 public:
  virtual ~Road() = default;
  virtual void add(const core::VehicleState& state) = 0;
  virtual void add(const core::SonarImage& image) = 0;
  virtual void finish() = 0;
};

template <class Chain>
class ChainRoad : public Road {
 public:
  template <class... Arguments>
  explicit ChainRoad(Arguments&&... arguments) : chain_(std::forward<Arguments>(arguments)...) {}
  void add(const core::VehicleState& state) override { chain_.add(state); }
  void add(const core::SonarImage& image) override { chain_.add(image); }
  void finish() override { chain_.finish(); }

 private:
  Chain chain_;
};

tracking::DetectionParams detection_params(const sonar_sim::ImagePlan& plan) {
  tracking::DetectionParams params;
  params.echo.pulse_length = kPulseLength * plan.pulse_sigma;
  params.echo.beam_width = (plan.tapered ? kTaperedWidth : kLineWidth) * plan.beam_null;
  return params;
}

/// Geometry, mount and speed; what concerns returns is the detector's to say.
core::SonarParams told_of_images(const sonar_sim::Scene& scene) {
  core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms.front());
  sonar.miss_probability.reset();
  sonar.false_alarm_probability.reset();
  return sonar;
}

tracking::ChainParams chain_params(const std::string& tracker, const core::SonarParams& sonar,
                                   std::uint64_t seed) {
  tracking::ChainParams params;
  params.sensor = sonar;
  params.tracker.name = tracker;
  params.tracker.report_standing = tracker != "joint";
  params.seed = seed;
  return params;
}

std::unique_ptr<Road> make_road(const std::string& method, const sonar_sim::Scene& scene, std::uint64_t seed,
                                Answers& answers, const ImageOnlookers& onlookers) {
  if (std::find(kMethods.begin(), kMethods.end(), method) == kMethods.end())
    throw std::invalid_argument("no road from images to tracks is called " + method);
  const auto answer = [&answers](const tracking::PingResult& result) {
    answers[result.utime] = {result.tracks.begin(), result.tracks.end()};
  };
  const auto silent = [](const std::string&) {};
  const core::SonarParams sonar = told_of_images(scene);
  const std::string tracker = method.substr(std::min(method.size(), kDetect.size()));
  if (!method.starts_with(kDetect))
    return std::make_unique<ChainRoad<tracking::ImageChain>>(sonar, method, answer, silent);
  tracking::GivenFigures given;
  given.range_sigma = tracker == kHough;
  return std::make_unique<ChainRoad<tracking::DetectionChain>>(
      detection_params(*scene.platforms.front().image), chain_params(tracker, sonar, seed), given, answer,
      silent, onlookers.on_returns);
}

/// Sums over the pairs of target and track.
struct PairSums {
  double pairs = 0.0, squared_error = 0.0, nees = 0.0;

  void add(const tracking::TrackOnTarget& pair) {
    Eigen::Vector4d error = pair.track.state;
    error.head<2>() -= pair.target.position;
    error.tail<2>() -= pair.target.velocity;
    ++pairs;
    squared_error += error.head<2>().squaredNorm();
    nees += error.dot(pair.track.covariance.llt().solve(error)) / kDegrees;
  }
};

double visible_targets(const core::GroundTruth& truth) {
  return static_cast<double>(std::count_if(truth.targets.begin(), truth.targets.end(),
                                           [](const core::TargetTruth& t) { return t.visible; }));
}

/// False tracks that are seen after the first pings, in a hundred of them.
double false_per_hundred(const AnsweredRun& run) {
  tracking::TrackQuality settled({kGate});
  for (std::size_t k = kSettled; k < run.pings.size(); ++k)
    settled.add(run.pings[k].truth, run.pings[k].tracks);
  if (run.pings.size() <= kSettled + 1) return std::nan("");
  const auto pings = static_cast<double>(run.pings.size() - kSettled - 1);
  const double seconds = core::seconds(run.pings.back().truth.utime - run.pings[kSettled].truth.utime);
  return settled.result().false_per_100s * seconds / pings;
}

}  // namespace

std::span<const std::string_view> image_sea_methods() {
  return kMethods;
}

AnsweredRun track_images(const std::string& method, const sonar_sim::Scene& scene, std::uint64_t seed,
                         int run, const ImageOnlookers& onlookers) {
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run));
  Answers answers;
  const auto road = make_road(method, scene, run_seed(seed, run), answers, onlookers);
  AnsweredRun result;
  double spent_ms = 0.0;
  const auto timed = [&spent_ms](const auto& work) {
    const double start_ms = thread_time_ms();
    work();
    spent_ms += thread_time_ms() - start_ms;
  };
  while (const auto ping = simulator.next()) {
    if (onlookers.on_ping) onlookers.on_ping(*ping);
    timed([&] {
      for (const auto& state : ping->states_before) road->add(state);
      road->add(*ping->image);
      for (const auto& state : ping->states_after) road->add(state);
    });
    result.pings.push_back({ping->truth, {}});
  }
  timed([&] { road->finish(); });
  for (auto& ping : result.pings) ping.tracks = std::move(answers[ping.truth.utime]);
  if (!result.pings.empty()) result.time_ms = spent_ms / static_cast<double>(result.pings.size());
  return result;
}

Metrics score_images(const AnsweredRun& run) {
  tracking::Scorer scorer({}, tracking::TruthKind::visible);
  tracking::TrackQuality quality({kGate});
  PairSums sums;
  double targets = 0.0;
  for (const auto& ping : run.pings) {
    scorer.add(ping.truth, ping.tracks);
    quality.add(ping.truth, ping.tracks);
    for (const auto& pair : quality.pairs()) sums.add(pair);
    targets += visible_targets(ping.truth);
  }
  const tracking::OspaResult ospa = scorer.mean().position;
  Metrics metrics{{"ospa", ospa.total},
                  {"ospa_localization", ospa.localization},
                  {"ospa_cardinality", ospa.cardinality},
                  {"false_per_100_pings", false_per_hundred(run)},
                  {"time_ms", run.time_ms}};
  if (targets > 0.0) metrics["confirmed_share"] = {sums.pairs / targets, targets};
  if (sums.pairs == 0.0) return metrics;
  metrics["rmse"] = {std::sqrt(sums.squared_error / sums.pairs), sums.pairs};
  metrics["nees"] = {sums.nees / sums.pairs, sums.pairs};
  return metrics;
}

}  // namespace lookout::tools
