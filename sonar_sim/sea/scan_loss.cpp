#include "sonar_sim/sea/scan_loss.hpp"

namespace lookout::sonar_sim {

ScanFate draw_fate(const ScanLoss& loss, core::Random& random) {
  // Both are drawn at every scan, so that one probability does not move the draws of the other.
  const bool lost = random.bernoulli(loss.lost);
  const bool empty = random.bernoulli(loss.empty);
  if (lost) return ScanFate::lost;
  return empty ? ScanFate::empty : ScanFate::whole;
}

}  // namespace lookout::sonar_sim
