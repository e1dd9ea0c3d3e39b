#include "tools/tracking_chain.hpp"

namespace lookout::tools {

TrackingChain::TrackingChain(const Configuration& configuration, std::uint64_t seed)
    : tracker_(tracking::make_tracker(configuration.tracker.name, configuration.tracker, configuration.sensor,
                                      configuration.estimator, seed)) {}

void TrackingChain::add(const core::VehicleState& state) {
  history_.add(state);
  release();
}

void TrackingChain::add(const core::SonarScan& scan) {
  waiting_.push_back(scan);
  release();
}

void TrackingChain::release() {
  while (!waiting_.empty() && history_.reaches(waiting_.front().utime)) {
    const core::SonarScan& scan = waiting_.front();
    if (const auto body = history_.at(scan.utime)) {
      const auto tracks = tracker_->update({scan, core::compose(*body, scan.T_body_sonar)});
      const auto elements = tracker_->elements();
      output_.tracks.push_back({scan.utime, {tracks.begin(), tracks.end()}});
      output_.elements.push_back({scan.utime, {elements.begin(), elements.end()}});
    } else {
      ++output_.rejected;
    }
    waiting_.pop_front();
  }
}

}  // namespace lookout::tools
