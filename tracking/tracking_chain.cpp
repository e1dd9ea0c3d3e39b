#include "tracking/tracking_chain.hpp"

#include "core/field_of_view.hpp"
#include "tracking/ping_checks.hpp"

namespace lookout::tracking {

TrackingChain::TrackingChain(const core::SonarParams& configured, MakeTracker make_tracker,
                             OnTracks on_tracks, Report report, const IntakeParams& params)
    : configured_(configured),
      make_tracker_(std::move(make_tracker)),
      on_tracks_(std::move(on_tracks)),
      tracker_(make_tracker_(configured)),
      intake_(configured,
              {[this](const core::PosedScan& scan) { track(scan); }, [this] { reset(); }, std::move(report)},
              params) {}

void TrackingChain::track(const core::PosedScan& scan) {
  if (is_fresh_ && !agrees(scan.scan, configured_))
    tracker_ = make_tracker_(core::with_geometry_of(scan.scan, configured_));
  is_fresh_ = false;
  on_tracks_(scan, tracker_->update(scan), *tracker_);
}

void TrackingChain::reset() {
  tracker_ = make_tracker_(configured_);
  is_fresh_ = true;
}

}  // namespace lookout::tracking
