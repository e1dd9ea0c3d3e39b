#include "tracking/restart/scan_memory.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

/// A start must not take longer than a watchdog's patience: of scans with many returns fewer are kept, but as
/// many as a track's window has.
constexpr std::size_t kMostReturns = 4000, kFewest = 20;
/// A step of more than so many times the newest is a pause, and none of a slow sonar's.
constexpr std::int64_t kPause = 3;

}  // namespace

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
  const auto back = [this](std::size_t i) -> const core::RememberedScan& {
    return ring_[(next_ + ring_.size() - 1 - i) % ring_.size()];
  };
  const auto age = [&back](std::size_t i) { return back(0).scan.utime - back(i).scan.utime; };
  std::size_t returns = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    returns += back(i).scan.returns.size();
    const bool is_old = age(i) > params_.max_age && age(i) - age(i - 1) > kPause * age(1);
    if (is_old || (i >= kFewest && returns > kMostReturns)) break;
    kept.push_back(back(i));
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

}  // namespace lookout::tracking
