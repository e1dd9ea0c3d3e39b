#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/motion_element.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"
#include "csht/joint/target_search.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Begins tracks: on the hypotheses that the joint estimator found in the tracker's own scene, on the
/// elements of another estimator, or on what a birth method proposes. The last two are weighed as seeds.
class Births {
 public:
  /// @param params validated. @param proposals in place of motion elements; null: those.
  Births(const JointTrackerParams& params, std::unique_ptr<BirthMethod> proposals);

  /// Whether tracks begin on motion elements.
  bool takes_elements() const { return proposals_ == nullptr; }

  /// Begins tracks at the newest scan, which is `scan`.
  void begin(const core::PosedScan& scan, std::span<const core::MotionElement> elements, TrackerState& state);

 private:
  void weigh(std::span<const core::MotionElement> elements, TrackerState& state);
  std::span<const core::Track> living(const TrackerState& state);
  static void tell(std::span<const int> slots, const TrackerState& state);

  csht::TargetSearch search_;  ///< For elements of other methods.
  std::unique_ptr<BirthMethod> proposals_;
  std::vector<csht::BirthSeed> seeds_;
  std::vector<int> adopted_;
  std::vector<core::Track> living_;  ///< What `proposals_` is told of the tracks.
};

}  // namespace lookout::tracking
