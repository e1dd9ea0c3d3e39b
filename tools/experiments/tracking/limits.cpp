#include "tools/experiments/tracking/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "csht/joint/joint_estimator.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/nees.hpp"
#include "tools/experiments/tracking/sensor_knowledge.hpp"
#include "tools/experiments/window/least_squares_reference.hpp"
#include "tracking/metrics/ospa.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kWindowScene = "window_table2.yaml";
constexpr std::array kProbabilities{0.1, 0.3, 0.5, 0.7};
constexpr int kWindow = 20;                       // Scans: [Yan2018] section V.A.
constexpr std::array kExistences{0.6, 0.8, 0.9};  // The classes of the calibration lie between these.
constexpr int kPairWindow = 40;
constexpr double kOnTarget = 10.0;  // An element this near a target is that target's [m].
constexpr double kEmptySeaSeconds = 500.0;
constexpr double kPlaces = 10.0;     // `anywhere` moves each target by up to this, north and east [m] ...
constexpr double kVelocities = 0.5;  // ... and changes its velocity by up to this [m/s].

using Points = std::vector<Eigen::Vector2d>;

struct Window {
  std::vector<core::MotionElement> elements;
  std::vector<TimedScan> scans;
  core::SonarParams sonar;
  double odds = 0.0;  // Sum of the odds of all candidates, targets included.
};

SceneVariant variant_of(const Parameters& p) {
  return {p.number("p_false_alarm"), p.number("p_miss"), p.number("sigma"),
          sonar_sim::ClutterReading::literal};
}

double sum_of_odds(const csht::JointScene& scene) {
  double sum = 0.0;
  for (const auto& track : scene.tracks)
    if (track.used) sum += std::exp(track.log_odds);
  return sum;
}

Window estimate(const sonar_sim::Scene& scene, const SceneVariant& variant, int window_scans,
                std::uint64_t seed, int run) {
  Window window;
  window.scans = simulate(scene, seed, run);
  window.sonar = told_params(scene, variant, "known", seed, run);
  auto params = csht::JointEstimatorParams::window();
  params.window_scans = params.first_estimate_scans = window_scans;
  csht::JointEstimator estimator(params, window.sonar, seed + static_cast<std::uint64_t>(run));
  for (const auto& timed : window.scans) {
    const auto elements = estimator.update(timed.posed);
    window.elements.assign(elements.begin(), elements.end());
  }
  window.odds = sum_of_odds(estimator.scene());
  return window;
}

Points visible_positions(const core::GroundTruth& truth) {
  Points points;
  for (const auto& target : truth.targets)
    if (target.visible) points.push_back(target.position);
  return points;
}

double nearest(const Points& points, const Eigen::Vector2d& p_earth) {
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& point : points) distance = std::min(distance, (point - p_earth).norm());
  return distance;
}

double mean_square(const Points& truth, const Points& found) {
  double sum = 0.0;
  for (const auto& point : truth) sum += std::pow(nearest(found, point), 2);
  return sum / static_cast<double>(truth.size());
}

/// Efficiency pools as sqrt(sum bound^2 / sum error^2) over the windows with the right count.
Metrics bound_metrics(const Window& window) {
  const Points truth = visible_positions(window.scans.back().truth);
  Points found, reference;
  for (const auto& element : window.elements) found.push_back(element.position);
  for (const auto& fit : least_squares_reference(window.scans, window.sonar))
    reference.push_back(fit.state.head<2>());
  Metrics metrics;
  metrics["count_correct"] = found.size() == truth.size() ? 1.0 : 0.0;
  if (found.size() != truth.size() || reference.size() != truth.size()) return metrics;
  const double error = mean_square(truth, found), bound = mean_square(truth, reference);
  metrics["rmse"] = std::sqrt(error);
  metrics["bound"] = std::sqrt(bound);
  metrics["efficiency"] = Metric(std::sqrt(bound / error), error);
  return metrics;
}

/// Moves the targets in each run: the bearing error of a target is fixed by its place in the beam, so that
/// only many places show whether the covariance is true.
void move_targets(std::uint64_t seed, int run, sonar_sim::Scene& scene) {
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  const auto within = [&](double limit) {
    const double north = random.uniform(-limit, limit);
    return Eigen::Vector2d(north, random.uniform(-limit, limit));
  };
  for (auto& target : scene.targets) {
    target.position += within(kPlaces);
    target.velocity += within(kVelocities);
  }
}

Metrics calibrated_window(const sonar_sim::Scene& scene, const SceneVariant& variant, int window_scans,
                          std::uint64_t seed, int run) {
  const Window window = estimate(scene, variant, window_scans, seed, run);
  Metrics metrics = bound_metrics(window);
  if (metrics["count_correct"].value == 1.0)
    metrics["nees"] = mean_nees(window.scans.back().truth, window.elements);
  return metrics;
}

/// One window at each of the sixteen pairs: of the elements of a class of existence, the share on target.
Metrics calibration_metrics(std::uint64_t seed, int run) {
  std::array<double, 2> share{}, number{};
  for (const double p_miss : kProbabilities) {
    for (const double p_false_alarm : kProbabilities) {
      const SceneVariant variant{p_false_alarm, p_miss, 3.0, sonar_sim::ClutterReading::literal};
      const Window window = estimate(load_variant(kWindowScene, variant), variant, kWindow, seed, run);
      const Points truth = visible_positions(window.scans.back().truth);
      for (const auto& element : window.elements) {
        if (element.existence < kExistences.front() || element.existence >= kExistences.back()) continue;
        const std::size_t bin = element.existence >= kExistences[1] ? 1 : 0;
        number[bin] += 1.0;
        share[bin] += nearest(truth, element.position) < kOnTarget ? 1.0 : 0.0;
      }
    }
  }
  Metrics metrics;
  if (number[0] > 0.0) metrics["true_at_60_80"] = Metric(share[0] / number[0], number[0]);
  if (number[1] > 0.0) metrics["true_at_80_90"] = Metric(share[1] / number[1], number[1]);
  return metrics;
}

/// Pure clutter: the sum of odds over the number of targets that the prior expects is the mean likelihood
/// ratio, at most 1 on average.
Metrics clutter_metrics(const SceneVariant& variant, std::uint64_t seed, int run) {
  auto scene = load_variant(kWindowScene, variant);
  scene.targets.clear();
  const Window window = estimate(scene, variant, kWindow, seed, run);
  Metrics metrics;
  metrics["evidence"] = window.odds / csht::TargetPriorParams{}.expected_targets;
  metrics["count_correct"] = window.elements.empty() ? 1.0 : 0.0;
  return metrics;
}

/// A stream from an empty sea: unbroken reports of an element count once.
Metrics empty_sea_metrics(const SceneVariant& variant, std::uint64_t seed, int run) {
  auto scene = load_variant(kWindowScene, variant);
  scene.targets.clear();
  scene.duration = kEmptySeaSeconds;
  scene.platforms.front().vehicle = {};
  const auto sonar = told_params(scene, variant, "known", seed, run);
  csht::JointEstimator estimator({}, sonar, seed + static_cast<std::uint64_t>(run));
  std::vector<core::MotionElement> before;
  int began = 0;
  for (const auto& timed : simulate(scene, seed, run)) {
    const auto elements = estimator.update(timed.posed);
    for (const auto& element : elements) {
      const Eigen::Vector2d previous = element.position - sonar.scan_period * element.velocity;
      const auto same = [&](const auto& other) { return (other.position - previous).norm() < kOnTarget; };
      if (std::none_of(before.begin(), before.end(), same)) ++began;
    }
    before.assign(elements.begin(), elements.end());
  }
  Metrics metrics;
  metrics["false_per_100s"] = began / (0.01 * kEmptySeaSeconds);
  return metrics;
}

class Limits : public Experiment {
 public:
  std::string summary() const override {
    return "The joint estimator against the bound of perfect association; calibration; hard scenes";
  }
  std::string scenario() const override {
    return "tools/scenarios/window_table2.yaml, pair_parallel_8m.yaml, pair_crossing.yaml, pair_behind.yaml";
  }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  Pooling pooling(const std::string& metric) const override {
    return metric == "rmse" || metric == "bound" || metric == "efficiency" ? Pooling::root_mean_square
                                                                           : Pooling::mean;
  }
};

Cell limits_cell(const std::string& situation, double p_false_alarm, double p_miss, double sigma,
                 int window_scans) {
  Cell cell;
  cell.method = "joint";
  cell.parameters = {{"situation", situation},
                     {"p_false_alarm", p_false_alarm},
                     {"p_miss", p_miss},
                     {"sigma", sigma},
                     {"window_scans", static_cast<double>(window_scans)},
                     {"clutter", "literal"}};
  return cell;
}

std::vector<Cell> Limits::cells() const {
  std::vector<Cell> cells;
  for (const int window_scans : {20, 40, 60}) {
    for (const double p_miss : kProbabilities)
      for (const double p_false_alarm : kProbabilities)
        cells.push_back(limits_cell("window", p_false_alarm, p_miss, 3.0, window_scans));
    for (const double sigma : {1.0, 2.0, 4.0, 5.0})
      cells.push_back(limits_cell("window", 0.3, 0.3, sigma, window_scans));
  }
  for (const int window_scans : {20, 40})
    for (const double p : kProbabilities) cells.push_back(limits_cell("anywhere", p, p, 3.0, window_scans));
  for (const char* pair : {"pair_parallel_8m", "pair_crossing", "pair_behind"})
    cells.push_back(limits_cell(pair, 0.3, 0.3, 3.0, kPairWindow));
  cells.push_back(limits_cell("calibration", 0.0, 0.0, 3.0, kWindow));
  for (const double p : kProbabilities) cells.push_back(limits_cell("clutter_only", p, 0.3, 3.0, kWindow));
  cells.push_back(limits_cell("empty_sea", 0.7, 0.3, 3.0, kWindow));
  cells.back().max_runs = 10;  // Of 1000 scans each.
  return cells;
}

Metrics Limits::run(const Cell& cell, std::uint64_t seed, int run) const {
  const auto& p = cell.parameters;
  const std::string situation = p.text("situation");
  const SceneVariant variant = variant_of(p);
  if (situation == "calibration") return calibration_metrics(seed, run);
  if (situation == "clutter_only") return clutter_metrics(variant, seed, run);
  if (situation == "empty_sea") return empty_sea_metrics(variant, seed, run);
  const int window_scans = static_cast<int>(p.number("window_scans"));
  const bool table2 = situation == "window" || situation == "anywhere";
  auto scene = load_variant(table2 ? kWindowScene : situation + ".yaml", variant);
  if (situation == "anywhere") move_targets(seed, run, scene);
  begin_earlier(window_scans * scene.platforms.front().sonar.params.scan_period - scene.duration, scene);
  return calibrated_window(scene, variant, window_scans, seed, run);
}

}  // namespace

std::unique_ptr<Experiment> make_limits() {
  return std::make_unique<Limits>();
}

}  // namespace lookout::tools
