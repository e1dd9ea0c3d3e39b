#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/tracking_memory.hpp"

namespace lookout::tracking {

/// How much of the past is kept for a restart.
struct ScanMemoryParams {
  std::size_t max_scans = 80;         ///< >= 1. At two scans a second 40 s: longer than a track's window.
  std::int64_t max_age = 60'000'000;  ///< What lies behind a pause is kept so long [us], > 0.
};

/// The newest accepted scans, in fixed memory once warm.
class ScanMemory {
 public:
  /// @throws std::invalid_argument on params out of range.
  explicit ScanMemory(const ScanMemoryParams& params = {});

  void add(const core::SonarScan& scan, const core::Pose2& T_earth_body);  ///< The next accepted one.
  void forget() { count_ = 0; }                                            ///< Keeps none.
  std::vector<core::RememberedScan> scans() const;                         ///< In order of time.

 private:
  ScanMemoryParams params_;
  std::vector<core::RememberedScan> ring_;
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace lookout::tracking
