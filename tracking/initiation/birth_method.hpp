#pragma once

#include <span>

#include "core/motion_element.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

namespace lookout::tracking {

/// Where new tracks come from: one scan in, the targets that no track explains out. Estimators and every
/// registered initiator can stand behind it.
class BirthMethod {
 public:
  virtual ~BirthMethod() = default;

  /// Takes the next scan, later than all before it, and proposes births at its time.
  /// @param tracks the living tracks, predicted to the scan's time; what they explain is not proposed.
  /// @return valid until the next call; empty where nothing new is seen.
  virtual std::span<const core::MotionElement> propose(const core::PosedScan& scan,
                                                       std::span<const core::Track> tracks) = 0;
};

}  // namespace lookout::tracking
