#pragma once

#include "core/sonar_params.hpp"

namespace lookout::csht {

/// What a return may be in a beam that holds a target.
enum class ClutterModel {
  exclusive_beam,  ///< A beam with a target never carries a false alarm. [Yan2018] V. Light clutter is this
                   ///< model at its equivalent rate (sonar_sim::known_params).
  shared_beam,     ///< A false alarm can occur in a target's beam too; of both, either is reported.
  point            ///< No beams: any number of returns, Poisson clutter, Gaussian range and bearing.
};

/// The probabilities and accuracies that the likelihood needs.
struct SensorFigures {
  double miss_probability = 0.3;         ///< P_M of a target in view, in (0, 1).
  double false_alarm_probability = 0.3;  ///< P_F of an empty beam, in (0, 1). Unused by point.
  double clutter_per_scan = 5.0;         ///< Mean number of false returns in a scan, > 0. point alone.
  double range_sigma = 3.0;              ///< [m], > 0.
  double bearing_sigma = 0.01;           ///< [rad], > 0. Used by point, and by least squares everywhere.
  double resolution = 0.0;               ///< SonarParams::resolution [m], >= 0. Used by point.
  double heading_sigma = 0.0;            ///< Of the heading of a scan's pose [rad], >= 0. Used by beams.
  double position_sigma = 0.0;           ///< Of north and of east of a scan's pose [m], >= 0. The same.
  /// What P_M gains by the square of range over the maximum range, in [0, 1). Learnt; used by beams.
  double range_loss = 0.0;
  /// Share of a target's returns whose error has `kTailScale` times the sigma, in [0, 1). The same.
  double tail_share = 0.0;
  static constexpr double kTailScale = 3.0;  ///< See `tail_share`.
};

/// How the likelihood reads a scan.
struct SensorModelParams {
  ClutterModel clutter = ClutterModel::exclusive_beam;  ///< How false returns come about.
  /// Lowest log-likelihood ratio of a return that is not the target's, in [-50, 0). It stands for what the
  /// model leaves out. A lower one gains nothing, -3 doubles the false tracks (docs/scan_likelihood.md).
  double log_floor = -8.0;
  /// Noise takes returns out of (0, max_range], and a silence near either end is that much less of a miss.
  bool range_gate = true;
};

/// The figures that `params` holds, with the errors of the pose in the sigmas too, kept away from 0 and 1,
/// where a single scan would decide everything; defaults of SensorFigures where they are absent.
SensorFigures figures_of(const core::SonarParams& params);

/// point for a sensor without beams, else exclusive_beam.
ClutterModel clutter_model_of(const core::SonarParams& params);

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const SensorFigures& figures);
/// @throws std::invalid_argument showing the value that is out of range.
void validate(const SensorModelParams& params);

}  // namespace lookout::csht
