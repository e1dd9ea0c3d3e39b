#include "tracking/restart/scan_memory.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lookout::tracking {

ScanMemory::ScanMemory(const ScanMemoryParams& params) : params_(params) {
  if (params.max_scans < 1) throw std::invalid_argument("max_scans must be >= 1, got 0");
  if (params.max_age <= 0)
    throw std::invalid_argument("max_age must be > 0, got " + std::to_string(params.max_age));
  ring_.resize(params.max_scans);
}

void ScanMemory::add(const core::SonarScan& scan, const core::Pose2& T_earth_body) {
  ring_[next_].vehicle = {scan.utime, T_earth_body, {0.0, 0.0}};
  ring_[next_].scan = scan;
  next_ = (next_ + 1) % ring_.size();
  count_ = std::min(count_ + 1, ring_.size());
}

std::vector<core::RememberedScan> ScanMemory::scans() const {
  std::vector<core::RememberedScan> kept;
  if (count_ == 0) return kept;
  const std::int64_t newest = ring_[(next_ + ring_.size() - 1) % ring_.size()].scan.utime;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& remembered = ring_[(next_ + ring_.size() - count_ + i) % ring_.size()];
    if (newest - remembered.scan.utime <= params_.max_age) kept.push_back(remembered);
  }
  return kept;
}

}  // namespace lookout::tracking
