#include "csht/joint/density/target_track.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lookout::csht {

void RecentEvidence::add(double evidence, double expected) {
  evidence_[static_cast<std::size_t>(next_)] = evidence;
  expected_[static_cast<std::size_t>(next_)] = expected;
  next_ = (next_ + 1) % kCapacity;
  size_ = std::min(size_ + 1, kCapacity);
}

double RecentEvidence::sum(int scans) const {
  assert(scans <= size_);
  double sum = 0.0;
  for (int k = 1; k <= scans; ++k)
    sum += evidence_[static_cast<std::size_t>((next_ - k + kCapacity) % kCapacity)];
  return sum;
}

double RecentEvidence::expected(int scans) const {
  assert(scans <= size_);
  double sum = 0.0;
  for (int k = 1; k <= scans; ++k)
    sum += expected_[static_cast<std::size_t>((next_ - k + kCapacity) % kCapacity)];
  return sum;
}

double probability(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}
double log_odds(double probability) {
  return std::log(probability / (1.0 - probability));
}
double TargetTrack::existence() const {
  return probability(log_odds);
}

void TargetTrack::advance(double seconds) {
  cloud.predict(seconds);
  moments = cloud.moments();
}

void TargetTrack::begin(const Beginning& beginning) {
  used = true;
  moments = cloud.moments();
  log_odds = highest_log_odds = beginning.log_odds;
  log_density = beginning.log_density;
  recent.clear();
  first_scan = beginning.first_scan;
  first_utime = beginning.first_utime;
  last_detection_utime = in_view_utime = beginning.utime;
  remembers_birth = true;
  out_of_view = coasting = reported = confirmed_once = false;
  has_claims = claims_are_fresh = false;
}

}  // namespace lookout::csht
