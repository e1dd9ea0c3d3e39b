#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/motion_element.hpp"
#include "core/track.hpp"
#include "tracking/association/assignment.hpp"

namespace lookout::tracking {

/// How far a motion element may lie from the track that it belongs to. The first elements of a target rest on
/// three detections and may differ by more than the distance of two targets, so that the gate must widen with
/// the uncertainty of track and element.
struct ElementGate {
  double position = 10.0;  ///< Largest distance [m] of two exact states of one velocity, > 0.
  double velocity = 1.5;   ///< Largest difference of velocity [m/s] of two exact states in one place, > 0.
  double sigmas = 4.0;     ///< Standard deviations of both that widen it (root of the sum of squares), >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Which motion element belongs to which track: the one-to-one assignment of least
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
