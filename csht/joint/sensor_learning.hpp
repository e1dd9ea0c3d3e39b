#pragma once

#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/likelihood/sensor_figure_estimator.hpp"

namespace lookout::csht {

/// Learns the sensor's figures from beams that no track owns and from sure tracks on straight lines.
class SensorLearning {
 public:
  /// @param params validated. @param sonar its figures, where given, are used until the scans contradict
  /// them.
  SensorLearning(const SensorLearningParams& params, const core::SonarParams& sonar);

  /// Takes the newest scan in; where the figures changed, the likelihood follows.
  void learn(std::span<const TargetTrack> tracks, ScanLikelihood& likelihood);

  const SensorFigures& figures() const { return figures_.figures(); }
  core::SensorEstimate estimate() const { return figures_.estimate(); }

 private:
  bool changed(const SensorFigures& before) const;

  SensorLearningParams params_;
  SensorFigureEstimator figures_;
  std::vector<std::vector<Eigen::Vector4d>> samples_;
  std::vector<KnownTarget> targets_;
};

/// Equally likely trajectories of a cloud, `count` of them, by systematic resampling.
void resample(const TrajectoryCloud& cloud, int count, std::vector<Eigen::Vector4d>& samples);

}  // namespace lookout::csht
