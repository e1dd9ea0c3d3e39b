#include "csht/likelihood/clutter/burst_scans.hpp"

#include <algorithm>

#include "csht/likelihood/clutter/clutter_density.hpp"

namespace lookout::csht {

Burst BurstScans::take(double count, double expected) {
  const double prior = std::min(share(), kMostBursts);
  Excess burst;
  if (taken_ >= kLeastScans)
    burst = csht::excess(count, std::max(expected, returns_ / usual_scans_),
                         {prior, kShapeOfExcess, kMeanExcess});
  const double unusual = prior < kMostBursts ? burst.probability : 0.0;
  const double fading = 1.0 - 1.0 / kMemoryScans;
  for (double* sum : {&scans_, &bursts_, &usual_scans_, &returns_}) *sum *= fading;
  taken_ += 1.0;
  scans_ += 1.0;
  bursts_ += burst.probability;
  usual_scans_ += 1.0 - unusual;
  returns_ += (1.0 - unusual) * count;
  if (burst.probability < kBelieved) return {};
  return {unusual, burst.density()};
}

}  // namespace lookout::csht
