#pragma once

#include <span>
#include <vector>

#include "core/sonar_params.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/density/wander.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/joint/evidence/wander_learning.hpp"
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

  /// Takes in what the newest scan says of how a sure, moving target strays, unless that is given; and of the
  /// errors: where targets stray these are learnt by how well returns are foretold, and not by what is left
  /// about trajectories that only hold for a while. @param predicted before the scan is taken into it.
  void weigh_errors(const TargetTrack& predicted, const BeamMask* mask, const ScanTable& newest);

  const Wander& wander() const { return wander_; }        ///< How targets stray, as given or learnt.
  const SensorFigures& figures() const { return used_; }  ///< To be used for the next scan.
  /// What the scans say of P_F, P_M and sigma, each with its standard error.
  core::SensorEstimate estimate() const { return figures_.estimate(); }

 private:
  bool moves(const TargetTrack& track) const;
  void choose_wander();
  void choose_figures();
  bool changed(const SensorFigures& before) const;

  SensorLearningParams params_;
  double max_speed_;  ///< Of targets [m/s].
  core::SonarParams sonar_;
  Wander wander_;
  WanderLearning straying_;
  SensorFigures given_;
  SensorFigureEstimator figures_;
  SensorFigures used_;
  std::vector<std::vector<Eigen::Vector4d>> samples_;
  std::vector<KnownTarget> targets_;
};

/// Writes `count` equally likely trajectories of a cloud (position [m], velocity [m/s]) to `samples`, by
/// systematic resampling: [Kitagawa1996].
void resample(const TrajectoryCloud& cloud, int count, std::vector<Eigen::Vector4d>& samples);

}  // namespace lookout::csht
