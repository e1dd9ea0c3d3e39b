#pragma once

#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/error_scale.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/likelihood/sensor_figure_estimator.hpp"

namespace lookout::csht {

/// Learns the sensor's figures: P_M and sigma from tracks that probably exist, move over ground and do not
/// accelerate, P_F from beams that none of these owns.
class SensorLearning {
 public:
  /// @param params validated. @param sonar its figures, where given, are used until the scans contradict
  /// them.
  SensorLearning(const SensorLearningParams& params, const core::SonarParams& sonar);

  /// Takes the newest scan in. Where the figures changed by `least_change`, those of `likelihood` are
  /// rewritten.
  void learn(std::span<const TargetTrack> tracks, ScanLikelihood& likelihood);

  /// Takes in how well a sure target's trajectories, predicted to the newest scan, foretell its returns;
  /// where targets stray the errors are learnt by that, and not by what is left about trajectories that only
  /// hold for a while.
  void weigh_errors(const TrajectoryCloud& predicted, const BeamMask* mask, const ScanTable& newest);

  const SensorFigures& figures() const { return used_; }  ///< To be used for the next scan.
  /// What the scans say of P_F, P_M and sigma, each with its standard error.
  core::SensorEstimate estimate() const { return figures_.estimate(); }

 private:
  bool moves(const TargetTrack& track) const;
  void choose_figures();
  bool changed(const SensorFigures& before) const;

  SensorLearningParams params_;
  double max_speed_;  ///< Of targets [m/s].
  bool targets_stray_;
  SensorFigures given_;
  SensorFigureEstimator figures_;
  ErrorScale errors_;
  SensorFigures used_;
  std::vector<std::vector<Eigen::Vector4d>> samples_;
  std::vector<KnownTarget> targets_;
};

/// Writes `count` equally likely trajectories of a cloud (position [m], velocity [m/s]) to `samples`, by
/// systematic resampling: [Kitagawa1996].
void resample(const TrajectoryCloud& cloud, int count, std::vector<Eigen::Vector4d>& samples);

}  // namespace lookout::csht
