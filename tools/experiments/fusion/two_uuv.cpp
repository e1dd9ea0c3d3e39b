#include "tools/experiments/fusion/two_uuv.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "tools/cli/paths.hpp"
#include "tools/experiments/fusion/fused_run.hpp"
#include "tracking/association/assignment.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/track_quality.hpp"

namespace lookout::tools {
namespace {

constexpr int kRivalRuns = 20;         // Of the methods that are there for comparison.
constexpr double kOutageBegin = 40.0;  // [s], in situation `restart`.
constexpr double kOutageEnd = 50.0;    // [s]
constexpr std::int32_t kFailingNode = 2;
constexpr double kHeldWithin = 10.0;  // A track farther off is another target's [m]: half of the cutoff.
constexpr double kTurnsOfAge =
    8.0;  // Turns after which an estimate has no vote: three targets, twice, and loss.
constexpr double kAcousticDelay = 1.0;  // Modulation and way of a packet [s].
constexpr const char* kAcousticScene = "two_uuv_acoustic";

/// OSPA of every picture against every truth: `ospa` is that of the fused picture against the targets that
/// either vehicle sees; `_node_N` names another picture, `_truth_N` another truth.
class PictureScores {
 public:
  void add(const FusedScan& scan) {
    add_picture("ospa", scan.fused, scan);
    for (std::size_t i = 0; i < scan.own_tracks.size(); ++i)
      add_picture(std::string("ospa_node_").append(std::to_string(i + 1)), scan.own_tracks[i], scan);
  }

  void report(Metrics& metrics) const {
    for (const auto& [name, scorer] : scorers_) metrics[name] = scorer.mean().position.total;
    const auto fused = scorers_.at("ospa").mean().position;
    metrics["ospa_localization"] = fused.localization;
    metrics["ospa_cardinality"] = fused.cardinality;
  }

 private:
  void add_picture(const std::string& name, const std::vector<core::Track>& tracks, const FusedScan& scan) {
    scorers_[name].add(scan.truth, tracks);
    for (std::size_t i = 0; i < scan.own_truth.size(); ++i)
      scorers_[name + "_truth_" + std::to_string(i + 1)].add(scan.own_truth[i], tracks);
  }

  std::map<std::string, tracking::Scorer> scorers_;
};

/// Errors of the tracks of targets that both vehicles see: there fusing is more than adding what the other
/// sees.
class SharedTargetErrors {
 public:
  void add(const FusedScan& scan) {
    add_picture("", scan.fused, scan);
    for (std::size_t i = 0; i < scan.own_tracks.size(); ++i)
      add_picture(std::string("_node_").append(std::to_string(i + 1)), scan.own_tracks[i], scan);
  }

  /// `rmse` [m] of the fused picture and `rmse_node_N` of the vehicles' own, over the targets that both see
  /// and the picture holds; `nees` and `held`, the share of them that it holds, likewise.
  void report(Metrics& metrics) const {
    for (const auto& [name, sums] : sums_) {
      metrics["held" + name] = {sums.held / std::max(1.0, sums.seen), sums.seen};
      if (sums.held == 0.0) continue;
      metrics["rmse" + name] = {std::sqrt(sums.squared / sums.held), sums.held};
      metrics["nees" + name] = {sums.nees / sums.held, sums.held};
    }
  }

 private:
  struct Sums {
    double squared = 0.0, nees = 0.0, held = 0.0, seen = 0.0;
  };

  static std::vector<const core::TargetTruth*> seen_by_both(const FusedScan& scan) {
    std::vector<const core::TargetTruth*> seen;
    for (std::size_t k = 0; k < scan.truth.targets.size(); ++k) {
      const bool by_all = std::all_of(scan.own_truth.begin(), scan.own_truth.end(),
                                      [&](const core::GroundTruth& own) { return own.targets[k].visible; });
      if (by_all) seen.push_back(&scan.truth.targets[k]);
    }
    return seen;
  }

  void add_picture(const std::string& name, const std::vector<core::Track>& tracks, const FusedScan& scan) {
    const auto seen = seen_by_both(scan);
    Sums& sums = sums_[name];
    sums.seen += static_cast<double>(seen.size());
    if (seen.empty() || tracks.empty()) return;
    Eigen::MatrixXd cost(static_cast<Eigen::Index>(seen.size()), static_cast<Eigen::Index>(tracks.size()));
    for (Eigen::Index i = 0; i < cost.rows(); ++i) {
      for (Eigen::Index j = 0; j < cost.cols(); ++j)
        cost(i, j) = std::min(kHeldWithin, (seen[static_cast<std::size_t>(i)]->position -
                                            tracks[static_cast<std::size_t>(j)].position())
                                               .norm());
    }
    const std::vector<int>& columns = solver_.solve(cost);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (columns[i] >= 0 && cost(static_cast<Eigen::Index>(i), columns[i]) < kHeldWithin)
        add_error(*seen[i], tracks[static_cast<std::size_t>(columns[i])], sums);
    }
  }

  static void add_error(const core::TargetTruth& target, const core::Track& track, Sums& sums) {
    constexpr double kDegrees = 4.0;
    Eigen::Vector4d error;
    error << track.position() - target.position, track.velocity() - target.velocity;
    sums.squared += error.head<2>().squaredNorm();
    sums.nees += error.dot(track.covariance.ldlt().solve(error)) / kDegrees;
    sums.held += 1.0;
  }

  std::map<std::string, Sums> sums_;
  tracking::AssignmentSolver solver_;
};

/// How many tracks of the vehicle that lives on changed their global number from the other's death to the
/// end.
int numbers_lost(const FusedRun& run, std::size_t survivor) {
  std::map<std::int64_t, std::int64_t> global_of;
  int lost = 0;
  for (const FusedScan& scan : run.scans) {
    if (core::seconds(scan.truth.utime) < kOutageBegin) {
      global_of.clear();
      for (const auto& [local, global] : scan.global_of[survivor]) {
        if (global >= 0) global_of[local] = global;
      }
      continue;
    }
    for (const auto& [local, global] : scan.global_of[survivor]) {
      const auto before = global_of.find(local);
      if (before == global_of.end() || before->second == global) continue;
      ++lost;
      global_of.erase(before);
    }
  }
  return lost;
}

class TwoUuv final : public Experiment {
 public:
  std::string summary() const override {
    return "two sonars with overlapping sectors fused at 256 bytes a second per node: OSPA of every picture";
  }
  std::string scenario() const override {
    return "tools/scenarios/two_uuv.yaml, two_uuv_fixed.yaml and two_uuv_acoustic.yaml";
  }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const char* scenario : {"two_uuv", "two_uuv_fixed"}) {
      for (const char* situation : {"steady", "restart"}) add("learned", scenario, situation, cells);
      for (const char* method : {"mean", "sdf", "sdf_fixed", "dw_a", "single", "ci"}) {
        add(method, scenario, "steady", cells);
        cells.back().max_runs = kRivalRuns;
      }
    }
    add("learned", kAcousticScene, "steady", cells);
    cells.back().max_runs = kRivalRuns;
    for (const char* method : {"learned", "ci_trace", "single"}) {
      for (const double turn : {10.0, 30.0, 60.0}) {
        add(method, kAcousticScene, "acoustic", cells);
        cells.back().parameters.set("turn_s", turn);
        cells.back().parameters.set("loss", 0.2);
        cells.back().max_runs = kRivalRuns;
      }
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const auto scene =
        sonar_sim::load_scene(tools_directory() + "/scenarios/" + cell.parameters.text("scenario") + ".yaml");
    const FusedRun fused = run_fused(scene, params_of(cell), seed, run);
    PictureScores scores;
    SharedTargetErrors shared;
    tracking::TrackQuality quality;
    for (const FusedScan& scan : fused.scans) {
      scores.add(scan);
      shared.add(scan);
      quality.add(scan.truth, scan.fused);
    }
    Metrics metrics;
    scores.report(metrics);
    shared.report(metrics);
    const auto followed = quality.result();
    metrics["identity_switches"] = followed.identity_switches;
    metrics["followed_share"] = followed.followed_share;
    metrics["false_per_100s"] = followed.false_per_100s;
    metrics["numbers_lost"] = numbers_lost(fused, 0);
    for (std::size_t i = 0; i < fused.links.size(); ++i) {
      const std::string node = std::string("_node_").append(std::to_string(i + 1));
      metrics["bytes_per_s" + node] = fused.links[i].bytes_per_second;
      metrics["most_bytes_in_1s" + node] = static_cast<double>(fused.links[i].most_bytes_in_a_second);
      metrics["longest_wait_s" + node] = fused.links[i].longest_wait;
    }
    return metrics;
  }

  /// RMSE are pooled over the track times of all runs.
  Pooling pooling(const std::string& metric) const override {
    return metric.starts_with("rmse") ? Pooling::root_mean_square : Pooling::mean;
  }

  /// The fused picture over the better vehicle's, of the pooled figures: of the whole picture, which shows
  /// what joint coverage brings, and of the error of the targets that both see, which shows what fusing
  /// brings.
  void complete(Estimates& estimates) const override {
    add_ratio("ospa", estimates);
    add_ratio("rmse", estimates);
  }

 private:
  static void add_ratio(const std::string& metric, Estimates& estimates) {
    for (const char* picture : {"", "_node_1", "_node_2"}) {
      if (!estimates.contains(metric + picture)) return;
    }
    const Estimate fused = estimates.at(metric), one = estimates.at(metric + "_node_1"),
                   two = estimates.at(metric + "_node_2");
    const Estimate& better = one.mean < two.mean ? one : two;
    const double ratio = fused.mean / better.mean;
    estimates[metric + "_ratio"] = {
        ratio, ratio * std::hypot(fused.ci95 / fused.mean, better.ci95 / better.mean), fused.runs};
  }

  static void add(const std::string& method, const std::string& scenario, const std::string& situation,
                  std::vector<Cell>& cells) {
    cells.push_back({method, {{"scenario", scenario}, {"situation", situation}}, {}});
  }

  static FusedRunParams params_of(const Cell& cell) {
    FusedRunParams params;
    params.fusion.method = cell.method;
    params.link.with_covariance = make_fusion_method(params.fusion)->needs_covariance();
    if (cell.parameters.text("situation") == "restart")
      params.outage = {kFailingNode, kOutageBegin, kOutageEnd};
    if (cell.parameters.text("situation") == "acoustic") {
      const double turn = cell.parameters.number("turn_s");
      params.acoustic = {turn, cell.parameters.number("loss"), kAcousticDelay};
      params.fusion.store.min_estimates = 1;
      params.fusion.global.birth_estimates = 1;
      params.fusion.store.max_age = params.fusion.store.max_silence = kTurnsOfAge * turn;
      params.fusion.store.forget_after = params.fusion.store.max_age;
      params.fusion.clock.max_interval = kTurnsOfAge * turn;
    }
    return params;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_two_uuv() {
  return std::make_unique<TwoUuv>();
}

}  // namespace lookout::tools
