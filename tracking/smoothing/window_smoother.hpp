#pragma once

#include "core/detection.hpp"
#include "core/motion_element.hpp"
#include "core/sonar_params.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// When a track follows its own filter and when the estimate of the window.
struct WindowSmootherParams {
  /// Squared Mahalanobis distance, under the sum of both covariances, that resets to the window estimate, >
  /// 0. Both treat bearing errors as independent, which they are not while a target stays in one beam: at 16
  /// most resets would hit a filter that is right.
  double disagreement = 36.0;
  int young_scans = 6;  ///< Scans from birth in which the window estimate is taken as it is, >= 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Corrects one predicted track. Windows that slide by one scan share all but one of their scans, so
/// their estimates are no independent measurements: the filter takes the new scan's own detection alone, and
/// the window estimate only replaces it where the track is young or the two disagree.
class WindowSmoother {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit WindowSmoother(const WindowSmootherParams& params);

  /// @param age scans since birth; @param detection the detection of the new scan that belongs to the
  /// track, if there is one; @param element the window estimate that belongs to it, if there is one.
  void correct(core::Track& track, int age, const core::Detection* detection,
               const core::MotionElement* element, const core::SonarParams& sonar) const;

 private:
  bool disagree(const core::Track& track, const core::MotionElement& element) const;

  WindowSmootherParams params_;
};

}  // namespace lookout::tracking
