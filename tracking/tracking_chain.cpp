#include "tracking/tracking_chain.hpp"

#include <limits>
#include <stdexcept>

#include "core/field_of_view.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {

TrackingChain::TrackingChain(const core::SonarParams& configured, MakeTracker make_tracker,
                             OnResult on_result, Report report, const ChainParams& params)
    : configured_(configured),
      make_tracker_(std::move(make_tracker)),
      on_result_(std::move(on_result)),
      lag_(params.lag),
      tracker_(make_tracker_(configured)),
      intake_(configured,
              {[this](const core::PosedScan& scan) { track(scan); }, [this] { reset(); }, std::move(report)},
              params.intake) {
  if (lag_ < 0 || lag_ > ChainParams::kMaxLag)
    throw std::invalid_argument("lag must be in [0, 60 s], got " + std::to_string(lag_) + " us");
  if (lag_ > 0 && !tracker_->can_retrodict())
    throw std::invalid_argument("this tracker has no delayed output, expected lag 0, got " +
                                std::to_string(lag_) + " us");
}

void TrackingChain::finish() {
  intake_.finish();
  give_until(std::numeric_limits<std::int64_t>::max());
}

void TrackingChain::track(const core::PosedScan& scan) {
  if (is_fresh_ && !agrees(scan.scan, configured_))
    tracker_ = make_tracker_(core::with_geometry_of(scan.scan, configured_));
  is_fresh_ = false;
  const auto tracks = tracker_->update(scan);
  if (lag_ == 0) return on_result_({scan, tracks, tracker_->elements(), tracker_->sensor_estimate()});
  delay(scan);
  give_until(scan.scan.utime - lag_);
}

void TrackingChain::delay(const core::PosedScan& scan) {
  const auto elements = tracker_->elements();
  delayed_.push_back({scan, {elements.begin(), elements.end()}, tracker_->sensor_estimate()});
}

void TrackingChain::give_until(std::int64_t utime) {
  while (!delayed_.empty() && delayed_.front().scan.scan.utime <= utime) {
    const Delayed& due = delayed_.front();
    on_result_({due.scan, tracker_->retrodict(due.scan.scan.utime), due.elements, due.sensor_estimate});
    delayed_.pop_front();
  }
}

void TrackingChain::reset() {
  give_until(std::numeric_limits<std::int64_t>::max());
  tracker_ = make_tracker_(configured_);
  is_fresh_ = true;
}

}  // namespace lookout::tracking
