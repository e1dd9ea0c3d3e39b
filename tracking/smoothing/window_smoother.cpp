#include "tracking/smoothing/window_smoother.hpp"

#include <Eigen/Cholesky>
#include <stdexcept>
#include <string>

#include "tracking/association/gating.hpp"
#include "tracking/smoothing/constant_velocity_filter.hpp"

namespace lookout::tracking {

void WindowSmootherParams::validate() const {
  if (!(disagreement > 0.0))
    throw std::invalid_argument("disagreement must be > 0, got " + std::to_string(disagreement));
  if (young_scans < 0)
    throw std::invalid_argument("young_scans must be >= 0, got " + std::to_string(young_scans));
}

WindowSmoother::WindowSmoother(const WindowSmootherParams& params) : params_(params) {
  params_.validate();
}

void WindowSmoother::correct(core::Track& track, int age, const core::Detection* sample,
                             const core::MotionElement* element, const core::SonarParams& sonar) const {
  if (sample != nullptr) {
    update(track, sample->p_earth, position_noise(*sample, sonar));
    track.last_detection_utime = sample->utime;
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
