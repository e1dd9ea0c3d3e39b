#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/motion_element.hpp"
#include "core/track.hpp"
#include "tracking/association/assignment.hpp"

namespace lookout::tracking {

/// How far a window estimate may lie from its trajectory. The first estimates of a target come from three
/// echoes and differ by more than two targets do: the gate is wider by their own uncertainty.
struct ElementGate {
  double position = 10.0;  ///< Distance [m] at which position alone closes the gate of two exact states, > 0.
  double velocity = 1.5;   ///< The same of velocity [m/s], > 0.
  double sigmas = 4.0;     ///< Standard deviations of both that widen it (root of the sum of squares), >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Which motion element belongs to which trajectory: the one-to-one assignment of least
/// (distance / position gate)^2 + (speed difference / velocity gate)^2, no pair at 1 or above. [Yan2018] Sec.
/// IV.
class TrackToElement {
 public:
  /// @throws std::invalid_argument on a gate that is not above 0.
  explicit TrackToElement(const ElementGate& gate);

  /// @param tracks predicted to the time of the elements.
  /// @return for each track the index of its element, or -1; valid until the next call.
  const std::vector<int>& assign(std::span<const core::Track> tracks,
                                 std::span<const core::MotionElement> elements);

 private:
  double cost(const core::Track& track, const core::MotionElement& element) const;

  ElementGate gate_;
  AssignmentSolver solver_;
  Eigen::MatrixXd cost_;
  std::vector<int> element_of_track_;
};

}  // namespace lookout::tracking
