#include "csht/refit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/parameter_check.hpp"

namespace lookout::csht {

Refit::Refit(const RefitParams& params) : params_(params) {
  for (const double slack : params.slack) core::require_not_negative("slack", slack);
  core::require(params.gate > 0.0, "gate must be > 0", params.gate);
  core::require(params.min_support >= 2, "min_support must be >= 2", params.min_support);
  core::require(params.max_speed > 0.0, "max_speed must be > 0", params.max_speed);
  core::require_not_negative("velocity_sigma", params.velocity_sigma);
}

bool Refit::fit(Candidate& candidate, const HoughWindow& window, double epoch,
                const std::vector<char>& free) const {
  for (const double slack : params_.slack) {
    choose_detections(candidate, window, epoch, free, slack);
    if (candidate.support < params_.min_support ||
        !least_squares(candidate, window, epoch, params_.velocity_sigma))
      return false;
  }
  return candidate.state.tail<2>().norm() <= params_.max_speed;
}

void Refit::choose_detections(Candidate& candidate, const HoughWindow& window, double epoch,
                              const std::vector<char>& free, double slack) const {
  const auto detections = window.detections();
  candidate.support = 0;
  for (std::size_t s = 0; s < window.scans().size(); ++s) {
    const auto& scan = window.scans()[s];
    const Eigen::Vector2d p_earth = candidate.position(scan.time - epoch);
    double nearest = params_.gate;
    candidate.own[s] = -1;
    for (int k = scan.first_detection; k < scan.first_detection + scan.num_detections; ++k) {
      const auto index = static_cast<std::size_t>(k);
      if (!free[index]) continue;
      const double distance = detections[index].distance(detections[index].p_earth - p_earth, slack) -
                              2.0 * log_background(detections[index]);
      if (distance >= nearest) continue;
      nearest = distance;
      candidate.own[s] = k;
    }
    if (candidate.own[s] >= 0) ++candidate.support;
  }
}

bool least_squares(Candidate& candidate, const HoughWindow& window, double epoch, double velocity_sigma) {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t s = 0; s < window.scans().size(); ++s) {
    if (candidate.own[s] < 0) continue;
    const auto& detection = window.detections()[static_cast<std::size_t>(candidate.own[s])];
    const Eigen::Vector2d u = detection.line_of_sight, w(-u.y(), u.x());
    const Eigen::Matrix2d weight =
        u * u.transpose() / detection.range_variance + w * w.transpose() / detection.cross_variance;
    const double t = detection.time - epoch;
    information.topLeftCorner<2, 2>() += weight;
    information.topRightCorner<2, 2>() += t * weight;
    information.bottomRightCorner<2, 2>() += t * t * weight;
    const Eigen::Vector2d weighted = weight * detection.p_earth;
    right.head<2>() += weighted;
    right.tail<2>() += t * weighted;
  }
  if (velocity_sigma > 0.0)
    information.bottomRightCorner<2, 2>() += Eigen::Matrix2d::Identity() / (velocity_sigma * velocity_sigma);
  information.bottomLeftCorner<2, 2>() = information.topRightCorner<2, 2>().transpose();
  const Eigen::LLT<Eigen::Matrix4d> factor(information);
  if (factor.info() != Eigen::Success) return false;
  candidate.state = factor.solve(right);
  candidate.covariance = factor.solve(Eigen::Matrix4d::Identity());
  return candidate.state.allFinite() && candidate.covariance.allFinite();
}

}  // namespace lookout::csht
