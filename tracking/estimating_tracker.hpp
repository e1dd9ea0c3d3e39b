#pragma once

#include <memory>
#include <span>
#include <utility>

#include "csht/motion_estimator.hpp"
#include "tracking/tracker.hpp"

namespace lookout::tracking {

/// A tracker that works on raw returns, with an estimator beside it: each scan goes to both, the tracks come
/// from the one, the motion elements from the other. Neither hears of the other.
class EstimatingTracker : public Tracker {
 public:
  /// Both must be set.
  EstimatingTracker(std::unique_ptr<Tracker> tracker, std::unique_ptr<csht::MotionEstimator> estimator);

  std::span<const core::Track> update(const core::PosedScan& scan) override;
  std::span<const core::MotionElement> elements() const override { return elements_; }
  std::optional<core::SensorEstimate> sensor_estimate() const override { return tracker_->sensor_estimate(); }
  void explain_to(DecisionLog log) override { tracker_->explain_to(std::move(log)); }
  bool can_retrodict() const override { return tracker_->can_retrodict(); }
  std::span<const core::Track> retrodict(std::int64_t utime) override { return tracker_->retrodict(utime); }

 private:
  std::unique_ptr<Tracker> tracker_;
  std::unique_ptr<csht::MotionEstimator> estimator_;
  std::span<const core::MotionElement> elements_;
};

}  // namespace lookout::tracking
