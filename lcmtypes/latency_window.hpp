#pragma once

#include <array>
#include <cstddef>

namespace lookout::lcmtypes {

/// Percentiles of the newest latencies, in fixed memory.
class LatencyWindow {
 public:
  static constexpr std::size_t kKept = 1000;  ///< Latencies that are kept.

  /// Takes a latency [ms]; the oldest goes where the window is full.
  void add(double milliseconds) {
    kept_[num_added_ % kKept] = milliseconds;
    ++num_added_;
  }
  /// The value that `share` (0 to 1) of those kept do not exceed [ms]; 0 before the first.
  double percentile(double share) const;

 private:
  std::array<double, kKept> kept_{};
  std::size_t num_added_ = 0;
};

}  // namespace lookout::lcmtypes
