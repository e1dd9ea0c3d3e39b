#include "tracking/baselines/gaussian/switching_motion.hpp"

#include <cmath>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {

void SwitchingMotionParams::validate() const {
  core::require(models == 1 || models == 2, "models must be 1 or 2", models);
  core::require_not_negative("steady_walk", steady_walk);
  core::require_not_negative("turning_walk", turning_walk);
  core::require_positive("steady_scans", steady_scans);
  core::require_positive("turning_scans", turning_scans);
  core::require_positive("first_speed", first_speed);
}

SwitchingMotion::SwitchingMotion(const SwitchingMotionParams& params, const core::SonarParams& sonar)
    : params_(params),
      scan_period_(sonar.scan_period),
      speed_variance_(std::pow(params.first_speed * sonar.max_speed, 2)) {
  params.validate();
  const double whole = params.steady_scans + params.turning_scans;
  density_ = {std::pow(params.steady_walk * sonar.max_speed, 2) / sonar.scan_period,
              std::pow(params.turning_walk * sonar.max_speed, 2) / sonar.scan_period};
  first_weight_ = {params.steady_scans / whole, params.turning_scans / whole};
  if (params.models == 1) first_weight_[0] = 1.0;
}

GaussianTarget SwitchingMotion::born(const PositionMeasurement& measurement) const {
  GaussianTarget target;
  target.num_modes = params_.models;
  for (std::size_t m = 0; m < target.used().size(); ++m) {
    GaussianMode& mode = target.modes[m];
    mode.weight = first_weight_[m];
    mode.mean << measurement.position, 0.0, 0.0;
    mode.covariance.topLeftCorner<2, 2>() = measurement.noise;
    mode.covariance.bottomRightCorner<2, 2>() = speed_variance_ * Eigen::Matrix2d::Identity();
  }
  return target;
}

void SwitchingMotion::predict(GaussianTarget& target, double seconds) const {
  if (target.num_modes > 1) interact(target, seconds);
  const Eigen::Matrix4d transition = core::constant_velocity_transition(seconds);
  for (std::size_t m = 0; m < target.used().size(); ++m) {
    GaussianMode& mode = target.modes[m];
    mode.mean = core::moved(mode.mean, seconds);
    mode.covariance = transition * mode.covariance * transition.transpose() +
                      core::white_acceleration_noise(seconds, density_[m]);
  }
}

// The time that a model lasts is exponential, so that the intervals between scans may differ.
void SwitchingMotion::interact(GaussianTarget& target, double seconds) const {
  const double scans = seconds / scan_period_;
  const double begins = -std::expm1(-scans / params_.steady_scans);
  const double ends = -std::expm1(-scans / params_.turning_scans);
  const double stay[2][2] = {{1.0 - begins, begins}, {ends, 1.0 - ends}};
  const GaussianTarget before = target;
  for (std::size_t to = 0; to < 2; ++to) {
    ModeSum sum(before.modes[0].mean);
    for (std::size_t from = 0; from < 2; ++from)
      sum.add(stay[from][to] * before.modes[from].weight, before.modes[from]);
    target.modes[to] = sum.merged();
  }
}

}  // namespace lookout::tracking
