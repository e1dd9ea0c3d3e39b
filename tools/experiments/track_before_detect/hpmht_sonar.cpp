#include "tools/experiments/track_before_detect/hpmht_sonar.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/files/csv.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/pgm.hpp"
#include "tools/cli/thread_time.hpp"
#include "tracking/association/assignment.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kScene = "sonar_image.yaml";
constexpr double kMatchDistance = 5.0;  // [m], within which a confirmed track is a target's
constexpr double kUnmatched = 1e6;
constexpr double kPictureSnr = 8.0;       // [dB]
constexpr double kPictureScale = 4096.0;  // normalised intensity to 16 bits

/// The scene at one level and background, with its targets or without.
sonar_sim::Scene scene_of(const Parameters& p) {
  sonar_sim::Scene scene = sonar_sim::load_scene(tools_directory() + "/scenarios/" + kScene);
  sonar_sim::ImagePlan& image = *scene.platforms.front().image;
  image.snr_db = p.number("snr_db");
  image.shape = p.number("shape");
  if (p.text("situation") == "empty") scene.targets.clear();
  return scene;
}

std::vector<core::Track> confirmed(std::span<const core::Track> tracks) {
  std::vector<core::Track> result;
  for (const core::Track& track : tracks)
    if (track.status == core::TrackStatus::confirmed) result.push_back(track);
  return result;
}

/// For each visible target the index of its confirmed track, or -1.
std::vector<int> match(const std::vector<core::TargetTruth>& targets,
                       const std::vector<core::Track>& tracks) {
  std::vector<int> pairs(targets.size(), -1);
  if (targets.empty() || tracks.empty()) return pairs;
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(targets.size()), static_cast<Eigen::Index>(tracks.size()));
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      const double distance =
          (targets[static_cast<std::size_t>(i)].position - tracks[static_cast<std::size_t>(j)].position())
              .norm();
      cost(i, j) = distance < kMatchDistance ? distance * distance : kUnmatched;
    }
  tracking::AssignmentSolver solver;
  const auto& assigned = solver.solve(cost);
  for (Eigen::Index i = 0; i < cost.rows(); ++i) {
    const int j = assigned[static_cast<std::size_t>(i)];
    if (j >= 0 && cost(i, j) < kUnmatched) pairs[static_cast<std::size_t>(i)] = j;
  }
  return pairs;
}

/// Sums over the pings of one run.
struct Score {
  int pings = 0, target_pings = 0, held = 0, false_tracks = 0;
  double squared_error = 0.0, nees = 0.0, update_ms = 0.0;
  std::map<int, double> first_held;  ///< Target id -> time of its first confirmed track [s].

  void add(const core::GroundTruth& truth, std::span<const core::Track> all) {
    const auto tracks = confirmed(all);
    std::vector<core::TargetTruth> targets;
    for (const auto& target : truth.targets)
      if (target.visible) targets.push_back(target);
    const auto pairs = match(targets, tracks);
    ++pings;
    target_pings += static_cast<int>(targets.size());
    false_tracks += static_cast<int>(tracks.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (pairs[i] < 0) continue;
      const core::Track& track = tracks[static_cast<std::size_t>(pairs[i])];
      const Eigen::Vector2d error = track.position() - targets[i].position;
      ++held;
      --false_tracks;
      squared_error += error.squaredNorm();
      nees += error.dot(track.covariance.topLeftCorner<2, 2>().llt().solve(error)) / 2.0;
      first_held.try_emplace(targets[i].id, core::seconds(truth.utime));
    }
  }
};

Score run_one(const std::string& method, const sonar_sim::Scene& scene, std::uint64_t seed, int run) {
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run));
  tracking::ImageTracker tracker(method);
  Score score;
  while (const auto ping = simulator.next()) {
    const core::PosedImage posed{*ping->image, ping->T_earth_sonar};
    const double start = thread_time_ms();
    const auto tracks = tracker.update(posed);
    score.update_ms += thread_time_ms() - start;
    score.add(ping->truth, tracks);
  }
  return score;
}

class HpmhtSonar : public Experiment {
 public:
  std::string summary() const override {
    return "Five targets in 60 sonar images, 4 to 12 dB, beside matched filter and CFAR with nearest "
           "neighbours";
  }
  std::string scenario() const override { return std::string("tools/scenarios/") + kScene; }
  std::string plot_script() const override { return "plot_hpmht.py"; }
  std::vector<Cell> cells() const override;
  Metrics run(const Cell& cell, std::uint64_t seed, int run) const override;
  Pooling pooling(const std::string& metric) const override {
    return metric == "rmse" ? Pooling::root_mean_square : Pooling::mean;
  }
  void write_extras(const Drawn& drawn) const override;
};

Cell cell_of(std::string_view method, const char* situation, double shape, double snr_db) {
  return {std::string(method), {{"situation", situation}, {"shape", shape}, {"snr_db", snr_db}}, {}};
}

std::vector<Cell> HpmhtSonar::cells() const {
  std::vector<Cell> cells;
  for (const std::string_view method : tracking::image_tracker_names()) {
    for (const double snr_db : {4.0, 6.0, 8.0, 10.0, 12.0})
      cells.push_back(cell_of(method, "five_targets", 4.0, snr_db));
    cells.push_back(cell_of(method, "empty", 4.0, 8.0));
  }
  // A heavier tail: the baselines' fixed thresholds were set at shape 4 and do not stand for them there.
  for (const double shape : {1.0, 0.5}) {
    for (const double snr_db : {8.0, 10.0}) cells.push_back(cell_of("h_pmht", "five_targets", shape, snr_db));
    cells.push_back(cell_of("h_pmht", "empty", shape, 8.0));
  }
  return cells;
}

Metrics HpmhtSonar::run(const Cell& cell, std::uint64_t seed, int run) const {
  const Score score = run_one(cell.method, scene_of(cell.parameters), seed, run);
  const double pings = score.pings, held = score.held;
  Metrics metrics;
  metrics["false_per_scan"] = {score.false_tracks / pings, pings};
  metrics["false_per_run"] = static_cast<double>(score.false_tracks);
  metrics["time_ms"] = score.update_ms / pings;
  if (score.target_pings == 0) return metrics;
  metrics["in_track"] = {held / score.target_pings, static_cast<double>(score.target_pings)};
  if (score.held == 0) return metrics;
  metrics["rmse"] = {std::sqrt(score.squared_error / held), held};
  metrics["nees"] = {score.nees / held, held};
  double wait = 0.0;
  for (const auto& [id, time] : score.first_held) wait += time / static_cast<double>(score.first_held.size());
  metrics["time_to_confirm_s"] = {wait, static_cast<double>(score.first_held.size())};
  return metrics;
}

/// One run at the level of the pictures: the last ping normalised, tracks with existence, truth; cells of the
/// last ping for the overlay.
void HpmhtSonar::write_extras(const Drawn& drawn) const {
  if (drawn.of_method("h_pmht").empty()) return;
  const std::string& directory = drawn.directory;
  const sonar_sim::Scene scene =
      scene_of({{"situation", "five_targets"}, {"shape", 4.0}, {"snr_db", kPictureSnr}});
  sonar_sim::SonarSimulator simulator(scene, drawn.seed);
  tracking::ImageTracker tracker;
  tracking::ImageBackground background;
  core::CsvWriter tracks(directory + "/sonar_tracks.csv",
                         "time_s,id,status,north_m,east_m,existence,bin,beam");
  core::CsvWriter truth(directory + "/sonar_truth.csv", "time_s,id,north_m,east_m,bin,beam");
  while (const auto ping = simulator.next()) {
    const core::PosedImage posed{*ping->image, ping->T_earth_sonar};
    const tracking::SonarCellGeometry geometry(posed);
    const double time = core::seconds(ping->truth.utime);
    for (const core::Track& track : tracker.update(posed)) {
      const Eigen::Vector2d cell = geometry.observe(track.position()).cell;
      tracks.number(time).integer(track.id).text(core::to_string(track.status)).number(track.state[0]);
      tracks.number(track.state[1]).number(track.existence).number(cell.x()).number(cell.y());
      tracks.end_row();
    }
    for (const core::TargetTruth& target : ping->truth.targets) {
      const Eigen::Vector2d cell = geometry.observe(target.position).cell;
      truth.number(time).integer(target.id).number(target.position.x()).number(target.position.y());
      truth.number(cell.x()).number(cell.y());
      truth.end_row();
    }
    const tracking::IntensityFrame& frame = background.normalise(posed);
    GreyImage picture{frame.columns, frame.rows, frame.values};
    for (double& pixel : picture.pixels) pixel *= kPictureScale;
    write_pgm(directory + "/sonar_image.pgm", picture);  // the last one stays
  }
  tracks.close();
  truth.close();
}

}  // namespace

std::unique_ptr<Experiment> make_hpmht_sonar() {
  return std::make_unique<HpmhtSonar>();
}

}  // namespace lookout::tools
