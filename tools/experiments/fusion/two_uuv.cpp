#include "tools/experiments/fusion/two_uuv.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/cli/paths.hpp"
#include "tools/experiments/fusion/fused_run.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/metrics/track_quality.hpp"

namespace lookout::tools {
namespace {

constexpr int kRivalRuns = 20;         // Of the methods that are there for comparison.
constexpr double kOutageBegin = 40.0;  // [s], in situation `restart`.
constexpr double kOutageEnd = 50.0;    // [s]
constexpr std::int32_t kFailingNode = 2;

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
  std::string scenario() const override { return "tools/scenarios/two_uuv.yaml and two_uuv_fixed.yaml"; }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const char* scenario : {"two_uuv", "two_uuv_fixed"}) {
      for (const char* situation : {"steady", "restart"}) add("learned", scenario, situation, cells);
      for (const char* method : {"mean", "sdf", "sdf_fixed", "dw_a", "single", "ci"}) {
        add(method, scenario, "steady", cells);
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
    tracking::TrackQuality quality;
    for (const FusedScan& scan : fused.scans) {
      scores.add(scan);
      quality.add(scan.truth, scan.fused);
    }
    Metrics metrics;
    scores.report(metrics);
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

  /// The fused picture over the better vehicle's, of the pooled figures.
  void complete(Estimates& estimates) const override {
    const Estimate fused = estimates.at("ospa"), one = estimates.at("ospa_node_1"),
                   two = estimates.at("ospa_node_2");
    const Estimate& better = one.mean < two.mean ? one : two;
    const double ratio = fused.mean / better.mean;
    estimates["ospa_ratio"] = {ratio, ratio * std::hypot(fused.ci95 / fused.mean, better.ci95 / better.mean),
                               fused.runs};
  }

 private:
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
    return params;
  }
};

}  // namespace

std::unique_ptr<Experiment> make_two_uuv() {
  return std::make_unique<TwoUuv>();
}

}  // namespace lookout::tools
