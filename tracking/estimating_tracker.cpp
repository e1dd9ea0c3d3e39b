#include "tracking/estimating_tracker.hpp"

#include <cassert>

namespace lookout::tracking {

EstimatingTracker::EstimatingTracker(std::unique_ptr<Tracker> tracker,
                                     std::unique_ptr<csht::MotionEstimator> estimator)
    : tracker_(std::move(tracker)), estimator_(std::move(estimator)) {
  assert(tracker_ && estimator_);
}

std::span<const core::Track> EstimatingTracker::update(const core::PosedScan& scan) {
  elements_ = estimator_->update(scan);
  return tracker_->update(scan);
}

}  // namespace lookout::tracking
