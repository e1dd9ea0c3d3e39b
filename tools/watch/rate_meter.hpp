#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace lookout::tools {

/// How often something arrives, of its newest arrivals.
class RateMeter {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kKept = 100;
  static constexpr std::chrono::seconds kMemory{30};  ///< Older arrivals count no more.

  void add(Clock::time_point now) {
    arrivals_.push_back(now);
    while (arrivals_.size() > kKept || now - arrivals_.front() > kMemory) arrivals_.pop_front();
  }
  /// Seconds since the newest arrival; nothing before the first.
  std::optional<double> age(Clock::time_point now) const {
    if (arrivals_.empty()) return std::nullopt;
    return std::chrono::duration<double>(now - arrivals_.back()).count();
  }
  /// Mean time between arrivals [s]; 0 before the second.
  double mean_gap() const {
    if (arrivals_.size() < 2) return 0.0;
    const auto gaps = static_cast<double>(arrivals_.size() - 1);
    return std::chrono::duration<double>(arrivals_.back() - arrivals_.front()).count() / gaps;
  }
  /// Arrivals a second [1/s]; 0 before the second, and sinking once they stop.
  double rate(Clock::time_point now) const {
    if (arrivals_.size() < 2) return 0.0;
    const double longest = std::max(mean_gap(), *age(now) / kPatience);
    return longest > 0.0 ? 1.0 / longest : 0.0;
  }

 private:
  static constexpr double kPatience = 3.0;  ///< Mean gaps that may pass before the rate sinks.

  std::deque<Clock::time_point> arrivals_;
};

}  // namespace lookout::tools
