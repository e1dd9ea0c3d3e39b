#include "tracking/initiation/proposed_births.hpp"

#include "core/field_of_view.hpp"

namespace lookout::tracking {

void begin_on_proposals(BirthMethod& births, const core::PosedScan& scan, const core::SonarParams& sonar,
                        TrackBook& book) {
  for (const core::MotionElement& element : births.propose(scan, book.tracks())) {
    if (!core::observe(sonar, scan.T_earth_sonar, element.position).visible()) continue;
    book.begin(scan.scan.utime, element.state(), element.covariance, "a proposal of the initiator");
    book.tracks().back().existence = element.existence;
  }
}

}  // namespace lookout::tracking
