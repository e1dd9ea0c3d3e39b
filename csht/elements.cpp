#include "csht/elements.hpp"

#include "core/constant_velocity.hpp"

namespace lookout::csht {

core::MotionElement to_element(const Candidate& candidate, const HoughWindow& window, double epoch) {
  const auto& first = window.scans().front();
  const auto& last = window.scans().back();
  const Eigen::Matrix4d transition = core::constant_velocity_transition(last.time - epoch);
  core::MotionElement element;
  element.initial_utime = first.utime;
  element.initial_position = candidate.position(first.time - epoch);
  element.velocity = candidate.state.tail<2>();
  element.position = candidate.position(last.time - epoch);
  element.covariance = transition * candidate.covariance * transition.transpose();
  element.score = candidate.log_evidence;
  element.support = candidate.support;
  element.of_known_track = candidate.offered;
  return element;
}

}  // namespace lookout::csht
