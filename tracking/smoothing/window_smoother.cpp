#include "tracking/smoothing/window_smoother.hpp"

#include <Eigen/Cholesky>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {

void WindowSmootherParams::validate() const {
  core::require(disagreement > 0.0, "disagreement must be > 0", disagreement);
  core::require(young_scans >= 0, "young_scans must be >= 0", young_scans);
}

WindowSmoother::WindowSmoother(const WindowSmootherParams& params) : params_(params) {
  params_.validate();
}

void WindowSmoother::correct(core::Track& track, int age, const core::Detection* detection,
                             const core::MotionElement* element, const core::SonarParams& sonar) const {
  if (detection != nullptr) {
    update(track, detection->p_earth, position_noise(*detection, sonar));
    track.last_detection_utime = detection->utime;
  }
  if (element == nullptr) return;
  if (age >= params_.young_scans && !disagree(track, *element)) return;
  track.state = element->state();
  track.covariance = element->covariance;
}

bool WindowSmoother::disagree(const core::Track& track, const core::MotionElement& element) const {
  const Eigen::Vector4d difference = track.state - element.state();
  const Eigen::Matrix4d spread = track.covariance + element.covariance;
  const double distance = difference.dot(spread.ldlt().solve(difference));
  return distance > params_.disagreement;
}

}  // namespace lookout::tracking
