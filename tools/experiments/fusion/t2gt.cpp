#include "tools/experiments/fusion/t2gt.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/files/csv.hpp"
#include "fusion/fusion.hpp"
#include "tools/experiments/harness/report.hpp"
#include "tools/experiments/initiation/radar_scene.hpp"
#include "tracking/association/assignment.hpp"

namespace lookout::tools {
namespace {

constexpr int kFirstScored = 6;  // Scans; docs/fusion.md.
constexpr int kBirthScan = 3;    // Global tracks are formed here; docs/fusion.md.
constexpr double kDefaultAzimuth = core::radians(0.05);
constexpr double kMostTargets = 4.0;
const Eigen::Vector2d kFusionNode(21000.0, 24000.0);
const std::vector<std::string> kNoises{"0.05deg", "0.5deg", "0.05rad"};

/// Of each target at each scan; NaN where its global track is gone.
using PerScan = std::array<std::array<double, kRadarScans>, 4>;
struct Errors {
  PerScan squared;  ///< Position error [m^2].
  PerScan nees;     ///< Of position and velocity under the stated covariance, over its four degrees.
};

RadarSceneParams scene_of(const Cell& cell) {
  RadarSceneParams params;
  const std::string noise = cell.parameters.text("azimuth_noise"), fault = cell.parameters.text("fault");
  params.azimuth_sigma = noise == "0.05rad" ? 0.05 : noise == "0.5deg" ? core::radians(0.5) : kDefaultAzimuth;
  params.fault = fault == "worse" ? RadarFault::worse : fault == "bias" ? RadarFault::bias : RadarFault::none;
  params.num_targets = static_cast<int>(cell.parameters.number("targets"));
  return params;
}

fusion::FusionParams fusion_of(const Cell& cell) {
  fusion::FusionParams params;
  params.method = cell.method;
  params.limits.max_speed = 1e4;                  // A first velocity at 0.05 rad may be far off.
  params.store.max_age = 0.5 * kRadarScanPeriod;  // A radar silent for a scan is left out of it.
  params.association.position_scale = 1500.0;     // These three: docs/fusion.md.
  params.association.speed_scale = 120.0;
  params.association.heading_scale = 0.6;
  if (cell.parameters.has("association") && cell.parameters.text("association") == "max")
    params.association.rule = fusion::AssociationRule::max;
  params.global.birth_estimates = kBirthScan + 1;
  params.learned.range_sigma = 100.0;  // docs/fusion.md; the bearing's is the default.
  params.kalman = {1.0, kRadarVelocitySigma};
  params.learned.process_noise = params.global.process_noise = params.kalman.process_noise;
  if (cell.parameters.has("support")) {
    const std::string support = cell.parameters.text("support");
    params.support_degree.reading = support == "all"   ? fusion::SupportReading::all
                                    : support == "col" ? fusion::SupportReading::col
                                                       : fusion::SupportReading::any;
  }
  if (cell.parameters.has("unit") && cell.parameters.text("unit") == "m")
    params.support_degree.length_unit = 1.0;
  if (cell.parameters.has("origin") && cell.parameters.text("origin") == "node")
    params.support_degree.p_earth_origin = kFusionNode;
  return params;
}

/// The global track that was formed for each target, by the best assignment of positions.
std::vector<std::int64_t> identities(std::span<const core::Track> tracks,
                                     std::span<const Eigen::Vector4d> truth) {
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(tracks.size()));
  for (Eigen::Index i = 0; i < cost.rows(); ++i) {
    for (Eigen::Index j = 0; j < cost.cols(); ++j)
      cost(i, j) =
          (truth[static_cast<std::size_t>(i)].head<2>() - tracks[static_cast<std::size_t>(j)].position())
              .norm();
  }
  std::vector<std::int64_t> ids(truth.size(), -1);
  if (tracks.empty()) return ids;
  tracking::AssignmentSolver solver;
  const std::vector<int>& columns = solver.solve(cost);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (columns[i] >= 0) ids[i] = tracks[static_cast<std::size_t>(columns[i])].id;
  }
  return ids;
}

/// A target whose global track was merged is followed by the one that was kept, unless another target has it.
void follow_mergers(const fusion::Fusion& fusion, std::vector<std::int64_t>& ids) {
  for (const auto& [ended, kept] : fusion.merged()) {
    if (std::find(ids.begin(), ids.end(), kept) == ids.end())
      std::replace(ids.begin(), ids.end(), ended, kept);
  }
}

/// Writes what the track `id` says of a target, where it is there.
void note_errors(std::span<const core::Track> tracks, std::int64_t id, const Eigen::Vector4d& truth,
                 double& squared, double& nees) {
  constexpr double kDegrees = 4.0;
  for (const core::Track& track : tracks) {
    if (track.id != id) continue;
    const Eigen::Vector4d error = track.state - truth;
    squared = error.head<2>().squaredNorm();
    nees = error.dot(track.covariance.ldlt().solve(error)) / kDegrees;
  }
}

bool is_heard(const Cell& cell, const fusion::LocalEstimate& estimate) {
  return !cell.parameters.has("radar") ||
         estimate.node_id == static_cast<int>(cell.parameters.number("radar"));
}

Errors errors_of_run(const Cell& cell, std::uint64_t seed, int run) {
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  fusion::Fusion fusion(fusion_of(cell));
  std::vector<std::int64_t> ids;
  Errors errors;
  for (PerScan* part : {&errors.squared, &errors.nees}) {
    for (auto& target : *part) target.fill(std::numeric_limits<double>::quiet_NaN());
  }
  int scan = 0;
  for (const RadarScan& heard : simulate_radars(scene_of(cell), random)) {
    for (const fusion::LocalEstimate& estimate : heard.estimates) {
      if (is_heard(cell, estimate)) fusion.add(estimate);
    }
    const auto tracks = fusion.update(core::microseconds(scan * kRadarScanPeriod));
    if (scan == kBirthScan) ids = identities(tracks, heard.truth);
    follow_mergers(fusion, ids);
    const auto k = static_cast<std::size_t>(scan++);
    for (std::size_t i = 0; i < ids.size(); ++i)
      note_errors(tracks, ids[i], heard.truth[i], errors.squared[i][k], errors.nees[i][k]);
  }
  return errors;
}

std::string target_metric(std::size_t target) {
  return std::string("rmse_").append(std::to_string(target + 1));
}

/// Mean over the scored scans, and how many of them had the track.
Metric mean_of(const std::array<double, kRadarScans>& values) {
  double sum = 0.0, count = 0.0;
  for (std::size_t scan = kFirstScored; scan < values.size(); ++scan) {
    if (!std::isfinite(values[scan])) continue;
    sum += values[scan];
    count += 1.0;
  }
  return {sum / count, count};
}

Metric rmse_of(const std::array<double, kRadarScans>& squared) {
  const Metric mean = mean_of(squared);
  return {std::sqrt(mean.value), mean.weight};
}

class T2gt final : public Experiment {
 public:
  std::string summary() const override {
    return "fusion of four radars' tracks of four targets (Li, Fan, Yuan, Li): position RMSE [m] by method";
  }
  std::string scenario() const override { return "tools/experiments/radar_scene.cpp"; }
  std::string plot_script() const override { return "plot_fusion.py"; }
  Pooling pooling(const std::string& metric) const override {
    return metric.starts_with("rmse") ? Pooling::root_mean_square : Pooling::mean;
  }

  std::vector<Cell> cells() const override {
    std::vector<Cell> cells;
    for (const auto& noise : kNoises) add_methods(noise, "none", cells);
    for (const char* fault : {"worse", "bias"}) add_methods("0.05deg", fault, cells);
    for (const auto& noise : kNoises) {
      for (const char* method : {"learned", "ml"})
        cells.push_back({method, {{"azimuth_noise", noise}, {"fault", "none"}, {"targets", 1.0}}, {}});
    }
    for (const char* support : {"any", "col"}) {
      cells.push_back({"sdf", with_all("0.05rad", "none"), {}});
      cells.back().parameters.set("support", support);
      cells.back().parameters.set("association", "max");
    }
    return cells;
  }

  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override {
    const Errors errors = errors_of_run(cell, seed, run);
    const auto targets = static_cast<std::size_t>(cell.parameters.number("targets"));
    Metrics metrics;
    double count = 0.0, nees = 0.0;
    for (std::size_t i = 0; i < targets; ++i) {
      const Metric own = rmse_of(errors.squared[i]);
      metrics[target_metric(i)] = own;
      count += own.weight;
      const Metric honesty = mean_of(errors.nees[i]);
      if (honesty.weight > 0.0) nees += honesty.value * honesty.weight;
    }
    if (count > 0.0) metrics["nees"] = {nees / count, count};
    metrics["followed_share"] = count / static_cast<double>(targets * (kRadarScans - kFirstScored));
    return metrics;
  }

  /// The figure of docs/results: the mean over the targets of each one's RMSE.
  void complete(Estimates& estimates) const override {
    Estimate mean;
    double count = 0.0, squared_width = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto own = estimates.find(target_metric(i));
      if (own == estimates.end()) continue;
      mean.mean += own->second.mean;
      squared_width += own->second.ci95 * own->second.ci95;
      mean.runs = own->second.runs;
      count += 1.0;
    }
    mean.mean /= count;
    mean.ci95 = std::sqrt(squared_width) / count;
    estimates["rmse"] = mean;
  }

  void write_extras(const Drawn& drawn) const override;

 private:
  static Parameters with_all(const std::string& noise, const std::string& fault) {
    return {{"azimuth_noise", noise}, {"fault", fault}, {"targets", 4.0}};
  }

  static void add_methods(const std::string& noise, const std::string& fault, std::vector<Cell>& cells) {
    const auto add = [&](const std::string& method, const Parameters& more) {
      cells.push_back({method, with_all(noise, fault), {}});
      for (const auto& [name, value] : more.values()) cells.back().parameters.set(name, value);
    };
    for (int radar = 1; radar <= kNumRadars; ++radar) add("single", {{"radar", static_cast<double>(radar)}});
    for (const char* method : {"mean", "dw_a", "dw_b", "dw_c", "dw_d"}) add(method, {});
    for (const char* support : {"any", "all", "col"}) add("sdf", {{"support", support}});
    add("sdf", {{"support", "any"}, {"origin", "node"}});
    add("sdf", {{"support", "any"}, {"unit", "m"}});
    for (const char* method : {"sdf_fixed", "learned", "ci", "ci_trace", "icov", "ml", "central"})
      add(method, {});
  }
};

/// The name of a curve: the method and what tells it from others of the same.
std::string curve_name(const Cell& cell) {
  const Parameters& parameters = cell.parameters;
  std::string name = cell.method;
  for (const char* key : {"support", "origin", "unit"}) {
    if (parameters.has(key)) name.append("_").append(parameters.text(key));
  }
  if (parameters.has("radar")) name.append("_").append(core::shortest(parameters.number("radar")));
  return name;
}

/// The root mean square error of each target at each scan over the runs, with its interval.
std::array<std::array<Estimate, kRadarScans>, 4> rmse_over_runs(const Cell& cell, const Drawn& drawn) {
  std::vector<PerScan> all(static_cast<std::size_t>(std::min(drawn.runs, cell.max_runs)));
  for (std::size_t run = 0; run < all.size(); ++run)
    all[run] = errors_of_run(cell, drawn.seed, static_cast<int>(run)).squared;
  std::vector<Metric> errors(all.size());
  std::array<std::array<Estimate, kRadarScans>, 4> rmse;
  for (std::size_t i = 0; i < rmse.size(); ++i) {
    for (std::size_t scan = 0; scan < kRadarScans; ++scan) {
      std::transform(all.begin(), all.end(), errors.begin(),
                     [&](const PerScan& run) { return std::sqrt(run[i][scan]); });
      rmse[i][scan] = pool(errors, Pooling::root_mean_square);
    }
  }
  return rmse;
}

/// [Li2018] Fig. 4: the error over time.
void write_curves(const Drawn& drawn, const std::string& path) {
  core::CsvWriter csv(path, "method,azimuth_noise,fault,target,time_s,rmse_m,ci95");
  for (const Cell& cell : drawn.cells) {
    const Parameters& parameters = cell.parameters;
    if (parameters.has("association") || parameters.number("targets") < kMostTargets) continue;
    const auto rmse = rmse_over_runs(cell, drawn);
    for (std::size_t i = 0; i < rmse.size(); ++i) {
      for (std::size_t scan = kBirthScan; scan < kRadarScans; ++scan) {
        csv.text(curve_name(cell)).text(parameters.text("azimuth_noise")).text(parameters.text("fault"));
        csv.integer(static_cast<std::int64_t>(i) + 1).number(static_cast<double>(scan) * kRadarScanPeriod);
        csv.number(rmse[i][scan].mean);
        std::isfinite(rmse[i][scan].ci95) ? csv.number(rmse[i][scan].ci95) : csv.blank();
        csv.end_row();
      }
    }
  }
  csv.close();
}

/// [Li2018] Fig. 2 and 3, of the first run: the true courses, what each radar tells, what a method makes of
/// it.
void write_scene(const Cell& cell, std::uint64_t seed, const std::string& path) {
  core::CsvWriter csv(path, "kind,id,time_s,north_m,east_m");
  const auto write = [&](const char* kind, std::int64_t id, double time, const Eigen::Vector4d& state) {
    csv.text(kind).integer(id).number(time).number(state(0)).number(state(1)).end_row();
  };
  core::Random random(seed, core::RandomStream::experiment, 0);
  fusion::Fusion fusion(fusion_of(cell));
  double time = 0.0;
  for (const RadarScan& heard : simulate_radars(scene_of(cell), random)) {
    for (std::size_t i = 0; i < heard.truth.size(); ++i)
      write("truth", static_cast<std::int64_t>(i) + 1, time, heard.truth[i]);
    for (const fusion::LocalEstimate& estimate : heard.estimates) {
      write("local", estimate.node_id, time, estimate.state);
      fusion.add(estimate);
    }
    for (const core::Track& track : fusion.update(core::microseconds(time)))
      write("fused", track.id, time, track.state);
    time += kRadarScanPeriod;
  }
  csv.close();
}

void T2gt::write_extras(const Drawn& drawn) const {
  write_curves(drawn, drawn.directory + "/rmse_over_time.csv");
  Parameters printed = with_all("0.05deg", "none");
  printed.set("support", "any");
  const std::vector<Cell> papers = drawn.of_method("sdf");
  Cell pictured = nearest_cell(papers.empty() ? drawn.cells : papers, printed);
  write_scene(pictured, drawn.seed, drawn.directory + "/scene.csv");
  pictured.parameters.set("method", pictured.method);
  write_pictured(pictured, drawn, 1, "scene");
}

}  // namespace

std::unique_ptr<Experiment> make_t2gt() {
  return std::make_unique<T2gt>();
}

}  // namespace lookout::tools
