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

/// Begins tracks: the joint estimator leaves its hypotheses in the tracker's own scene, where they are tracks
/// at once; elements of another estimator, or of a birth method, are weighed as seeds first.
class Births {
 public:
  /// @param params validated. @param proposals replaces the motion elements; null: they are used.
  Births(const JointTrackerParams& params, std::unique_ptr<BirthMethod> proposals);

  /// Whether tracks begin on motion elements.
  bool takes_elements() const { return proposals_ == nullptr; }

  /// Begins tracks at the newest scan, which is `scan`. @param elements that an estimator found in it.
  void begin(const core::PosedScan& scan, std::span<const core::MotionElement> elements, TrackerState& state);

 private:
  void weigh(std::span<const core::MotionElement> elements, TrackerState& state);
  std::span<const core::Track> living(const TrackerState& state);
  static void tell(std::span<const int> slots, const TrackerState& state);

  csht::TargetSearch search_;  ///< For elements of other methods.
  std::unique_ptr<BirthMethod> proposals_;
  std::vector<csht::BirthSeed> seeds_;
  std::vector<int> adopted_;
  std::vector<core::Track> living_;  ///< The tracks as `proposals_` takes them.
};

}  // namespace lookout::tracking
