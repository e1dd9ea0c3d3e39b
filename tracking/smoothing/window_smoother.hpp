#pragma once

#include "core/detection.hpp"
#include "core/motion_element.hpp"
#include "core/sonar_params.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// When a trajectory follows its own filter and when the window's estimate.
struct WindowSmootherParams {
  /// Squared Mahalanobis distance, under the sum of both covariances, that resets to the window estimate, >
  /// 0. Both take bearing errors for independent; while a target stays in a beam they are not, and at 16 most
  /// resets hit a good filter.
  double disagreement = 36.0;
  int young_scans = 6;  ///< Scans from birth in which the window estimate is taken as it is, >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Corrects one predicted trajectory. Windows that slide by one scan share all but one of their scans, so
/// their estimates are no independent measurements: the filter takes the new scan's own sample alone, and the
/// window estimate only replaces it where the trajectory is young or the two disagree.
class WindowSmoother {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit WindowSmoother(const WindowSmootherParams& params);

  /// @param age scans since birth; @param sample the detection of the new scan that belongs to the
  /// trajectory, if there is one; @param element the window estimate that belongs to it, if there is one.
  void correct(core::Track& track, int age, const core::Detection* sample, const core::MotionElement* element,
               const core::SonarParams& sonar) const;

 private:
  bool disagree(const core::Track& track, const core::MotionElement& element) const;

  WindowSmootherParams params_;
};

}  // namespace lookout::tracking
