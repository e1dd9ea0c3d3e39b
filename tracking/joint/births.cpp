#include "tracking/joint/births.hpp"

#include <utility>

namespace lookout::tracking {

Births::Births(const JointTrackerParams& params, std::unique_ptr<BirthMethod> proposals)
    : search_(params), proposals_(std::move(proposals)) {}

void Births::begin(const core::PosedScan& scan, std::span<const core::MotionElement> elements,
                   TrackerState& state) {
  if (proposals_ != nullptr) return weigh(proposals_->propose(scan, living(state)), state);
  adopted_.clear();
  for (const core::MotionElement& element : elements)
    if (element.hypothesis >= 0) adopted_.push_back(element.hypothesis);
  if (adopted_.empty()) return weigh(elements, state);
  tell(adopted_, state);
}

// Begins those elements of another method that are probable enough under the exact likelihood.
void Births::weigh(std::span<const core::MotionElement> elements, TrackerState& state) {
  seeds_.clear();
  for (const core::MotionElement& element : elements) seeds_.push_back(seed_of(element, state.scans()));
  tell(search_.weigh(seeds_, state), state);
}

std::span<const core::Track> Births::living(const TrackerState& state) {
  living_.clear();
  for (const csht::TargetTrack& track : state.tracks) {
    if (!track.used || track.existence() < csht::ScanLikelihood::kLeastExistence) continue;
    core::Track& living = living_.emplace_back();
    living.state = track.moments.mean.head<4>();
    living.covariance = track.moments.covariance.topLeftCorner<4, 4>();
  }
  return living_;
}

void Births::tell(std::span<const int> slots, const TrackerState& state) {
  for (const int slot : slots) {
    const csht::TargetTrack& track = state.tracks[static_cast<std::size_t>(slot)];
    state.decide(track, DecisionKind::begin, track.log_odds, "detections that no track explains");
  }
}

}  // namespace lookout::tracking
