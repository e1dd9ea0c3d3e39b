#include "tools/experiments/window/joint_window.hpp"

#include "core/files/csv.hpp"
#include "core/files/recording.hpp"
#include "csht/joint/joint_estimator.hpp"
#include "csht/scan_to_detections.hpp"

namespace lookout::tools {
namespace {

/// Trajectories with a weight each, a row a trajectory.
class TrajectoryFile {
 public:
  explicit TrajectoryFile(const std::string& path)
      : csv_(path, "north_m,east_m,north_velocity_mps,east_velocity_mps,weight") {}

  void add(const Eigen::Vector4d& state, double weight) {
    for (const double value : state) csv_.number(value);
    csv_.number(weight).end_row();
  }
  void close() { csv_.close(); }

 private:
  core::CsvWriter csv_;
};

/// The trajectories that stand for each hypothesis, weighted by the odds of its existence.
void write_hypotheses(const csht::JointScene& scene, const std::string& directory) {
  TrajectoryFile clouds(directory + "/joint_clouds.csv"), means(directory + "/joint_hypotheses.csv");
  for (const auto& track : scene.tracks) {
    if (!track.used) continue;
    means.add(track.moments.mean.head<4>(), track.log_odds);
    for (std::size_t i = 0; i < track.cloud.size(); ++i)
      clouds.add(track.cloud.trajectory(i).head<4>(), track.existence() * track.cloud.weight[i]);
  }
  clouds.close();
  means.close();
}

}  // namespace

void write_detections(const std::vector<TimedScan>& scans, const std::string& path) {
  core::CsvWriter csv(path, "time_s,north_m,east_m");
  std::vector<core::Detection> detections;
  for (const auto& timed : scans) {
    csht::scan_to_detections(timed.posed, 0, detections);
    for (const auto& echo : detections)
      csv.time(echo.utime).number(echo.p_earth.x()).number(echo.p_earth.y()).end_row();
  }
  csv.close();
}

void write_joint_window(const std::vector<TimedScan>& scans, const core::SonarParams& sonar,
                        std::uint64_t seed, const std::string& directory) {
  auto params = csht::JointEstimatorParams::window();
  params.window_scans = params.first_estimate_scans = static_cast<int>(scans.size());
  csht::JointEstimator estimator(params, sonar, seed);
  core::ElementList elements{scans.back().posed.scan.utime, {}};
  std::vector<core::GroundTruth> truth;
  for (const auto& timed : scans) {
    const auto found = estimator.update(timed.posed);
    elements.elements.assign(found.begin(), found.end());
    truth.push_back(timed.truth);
  }
  write_detections(scans, directory + "/joint_detections.csv");
  core::write_truth(directory + "/joint_truth.csv", truth);
  write_hypotheses(estimator.scene(), directory);
  core::write_elements(directory + "/joint_elements.csv", {elements});
}

}  // namespace lookout::tools
