#include "tracking/initiation/initiator.hpp"

namespace lookout::tracking {

void StartedTracks::clear() {
  tracks.clear();
  plots.clear();
  survivors.clear();
  refusal.clear();
}

}  // namespace lookout::tracking
