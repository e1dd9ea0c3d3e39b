#include "tracking/baselines/detection_tracker.hpp"

#include "core/field_of_view.hpp"
#include "tracking/initiation/proposed_births.hpp"

namespace lookout::tracking {

DetectionTracker::DetectionTracker(const TrackLifeParams& life, const csht::LocalClutterParams& clutter,
                                   const core::SonarParams& sonar, std::unique_ptr<BirthMethod> births)
    : book_(life),
      sonar_(sonar),
      clutter_(clutter, sonar),
      births_(std::move(births)),
      confirm_hits_(life.confirm_hits) {}

std::span<const core::Track> DetectionTracker::update(const core::PosedScan& scan,
                                                      std::span<const core::MotionElement> /*elements*/) {
  const core::SonarParams sonar = core::with_geometry_of(scan.scan, sonar_);
  clutter_.take(scan);
  free_detection_.assign(detections().size(), 1);
  takers_.assign(detections().size(), {});
  support_.assign(book_.tracks().size(), 0.0);
  take(scan, sonar);
  clutter_.learn(takers_);
  book_.step(scan, sonar, support_);
  begin(scan, sonar);
  rate();
  return book_.tracks();
}

void DetectionTracker::give(std::size_t detection, std::size_t track) {
  core::Track& taker = book_.tracks()[track];
  free_detection_[detection] = 0;
  support_[track] = worth()[detection].weight;
  takers_[detection] = {taker.id, taker.status != core::TrackStatus::tentative};
  taker.last_detection_utime = detections()[detection].utime;
}

void DetectionTracker::begin(const core::PosedScan& scan, const core::SonarParams& sonar) {
  if (births_ != nullptr) {
    begin_on_proposals(*births_, scan, sonar, book_);
    return;
  }
  for (std::size_t j = 0; j < detections().size(); ++j)
    if (free_detection_[j] && worth()[j].weight > 0.0) begin_on(detections()[j], sonar, worth()[j].weight);
}

// M-of-N knows no probability: confirmed counts as sure, tentative as the share of M, always below one half.
void DetectionTracker::rate() {
  const auto tracks = book_.tracks();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const double share = 0.5 * book_.life(i).hits() / (confirm_hits_ + 1.0);
    tracks[i].existence = tracks[i].status == core::TrackStatus::tentative ? share : 1.0;
  }
}

}  // namespace lookout::tracking
