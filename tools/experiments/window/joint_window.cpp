#include "tools/experiments/window/joint_window.hpp"

#include "core/csv.hpp"
#include "core/recording.hpp"
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

void write_search(const csht::JointSearch& search, const std::string& directory) {
  TrajectoryFile seeds(directory + "/joint_seeds.csv"), clusters(directory + "/joint_clusters.csv");
  for (const auto& seed : search.seeds()) seeds.add(seed.state, seed.score);
  for (const auto& target : search.targets()) clusters.add(target.mean, target.log_odds);
  for (const auto& candidate : search.candidates()) clusters.add(candidate.mean, candidate.log_odds);
  seeds.close();
  clusters.close();
}

}  // namespace

void write_echoes(const std::vector<TimedScan>& scans, const std::string& path) {
  core::CsvWriter csv(path, "time_s,north_m,east_m");
  std::vector<core::Detection> detections;
  for (const auto& timed : scans) {
    csht::scan_to_detections(timed.posed, 0, detections);
    for (const auto& echo : detections)
      csv.number(core::seconds(echo.utime)).number(echo.p_earth.x()).number(echo.p_earth.y()).end_row();
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
  write_echoes(scans, directory + "/joint_echoes.csv");
  core::write_truth(directory + "/joint_truth.csv", truth);
  write_search(estimator.search(), directory);
  core::write_elements(directory + "/joint_elements.csv", {elements});
}

}  // namespace lookout::tools
