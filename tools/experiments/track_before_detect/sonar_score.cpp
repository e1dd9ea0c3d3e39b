#include "tools/experiments/track_before_detect/sonar_score.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/thread_time.hpp"
#include "tracking/association/assignment.hpp"

namespace lookout::tools {
namespace {

constexpr double kMatchDistance = 5.0;  // [m], within which a confirmed track is a target's
constexpr double kUnmatched = 1e6;
constexpr double kDefaultShape = 4.0;
constexpr double kPositionDimension = 2.0, kStateDimension = 4.0;
// Of the scene: a pulse of sigma .55 m; a sinc with its null at 1.5 degrees, .75 degrees wide as a normal
// density.
constexpr double kPulseLength = 1.295;   // [m], full width at half amplitude
constexpr double kBeamWidthDeg = 1.766;  // likewise

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

}  // namespace

void SonarScore::add(const core::GroundTruth& truth, std::span<const core::Track> all) {
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
    Eigen::Vector4d error;
    error << track.position() - targets[i].position, track.velocity() - targets[i].velocity;
    const Eigen::Vector2d off = error.head<2>();
    ++held;
    --false_tracks;
    squared_error += off.squaredNorm();
    nees += off.dot(track.covariance.topLeftCorner<2, 2>().llt().solve(off)) / kPositionDimension;
    nees_state += error.dot(track.covariance.llt().solve(error)) / kStateDimension;
    first_held.try_emplace(targets[i].id, core::seconds(truth.utime));
  }
}

Metrics SonarScore::metrics() const {
  const double all = pings, in_track = held;
  Metrics metrics;
  metrics["false_per_scan"] = {false_tracks / all, all};
  metrics["false_per_run"] = static_cast<double>(false_tracks);
  metrics["time_ms"] = update_ms / all;
  if (target_pings == 0) return metrics;
  metrics["in_track"] = {in_track / target_pings, static_cast<double>(target_pings)};
  if (held == 0) return metrics;
  metrics["rmse"] = {std::sqrt(squared_error / in_track), in_track};
  metrics["nees"] = {nees / in_track, in_track};
  metrics["nees_state"] = {nees_state / in_track, in_track};
  double wait = 0.0;
  for (const auto& [id, time] : first_held) wait += time / static_cast<double>(first_held.size());
  metrics["time_to_confirm_s"] = {wait, static_cast<double>(first_held.size())};
  return metrics;
}

sonar_sim::Scene sonar_scene(const Parameters& p) {
  sonar_sim::Scene scene = sonar_sim::load_scene(tools_directory() + "/scenarios/sonar_image.yaml");
  sonar_sim::ImagePlan& image = *scene.platforms.front().image;
  image.snr_db = p.number("snr_db");
  image.shape = p.has("shape") ? p.number("shape") : kDefaultShape;
  if (p.has("situation") && p.text("situation") == "empty") scene.targets.clear();
  return scene;
}

tracking::InstrumentParams sonar_instrument(bool known) {
  if (!known) return {};
  return {kPulseLength, core::radians(kBeamWidthDeg)};
}

SonarScore score_run(tracking::ImageTracker& tracker, const sonar_sim::Scene& scene, std::uint64_t seed,
                     int run) {
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run));
  SonarScore score;
  while (const auto ping = simulator.next()) {
    const core::PosedImage posed{*ping->image, ping->T_earth_sonar};
    const double start = thread_time_ms();
    const auto tracks = tracker.update(posed);
    score.update_ms += thread_time_ms() - start;
    score.add(ping->truth, tracks);
  }
  return score;
}

}  // namespace lookout::tools
