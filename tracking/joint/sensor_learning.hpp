#pragma once

#include <vector>

#include "core/sonar_params.hpp"
#include "csht/likelihood/sensor_figure_estimator.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Learns the sensor's figures from beams that no track owns and from sure tracks on straight lines.
class SensorLearning {
 public:
  /// @param sonar its figures, where given, are used until the scans contradict them.
  SensorLearning(const SensorLearningParams& params, double least_existence, const core::SonarParams& sonar);

  /// Takes the newest scan in; where the figures changed, the likelihood follows.
  void learn(TrackerState& state);

  const csht::SensorFigures& figures() const { return figures_.figures(); }
  core::SensorEstimate estimate() const { return figures_.estimate(); }

 private:
  bool changed(const csht::SensorFigures& before) const;

  SensorLearningParams params_;
  double least_existence_;
  csht::SensorFigureEstimator figures_;
  std::vector<std::vector<Eigen::Vector4d>> samples_;
  std::vector<csht::KnownTarget> targets_;
};

/// Equally likely trajectories of a cloud, `count` of them, by systematic resampling.
void resample(const csht::TrajectoryCloud& cloud, int count, std::vector<Eigen::Vector4d>& samples);

}  // namespace lookout::tracking
