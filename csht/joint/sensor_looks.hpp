#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lookout::csht {

/// Which of a vehicle's sonars look, and when each did last: a target that one of them has in view is in
/// view, though the newest scan is another's.
class SensorLooks {
 public:
  /// Takes note of a scan. @return the sonar's number, counted from 0 in the order of their first scans; one
  /// beyond the first 64 shares the last number.
  int take(std::int32_t sensor_id, std::int64_t utime);

  bool several() const { return looks_.size() > 1; }  ///< More than one sonar was ever heard.
  /// The earliest of the newest scans of all sonars that still look [us]: those of which no more than
  /// `kSilentPeriods` of their own periods, or of the newest sonar's, have passed. Before any scan it is
  /// later than all.
  std::int64_t oldest() const;

  static constexpr std::size_t kMost = 64;  ///< Sonars that are told apart.
  static constexpr int kSilentPeriods = 4;  ///< After so many without a scan a sonar looks no more.

 private:
  struct Look {
    std::int32_t sensor_id = 0;
    std::int64_t utime = 0, period = 0;
  };

  std::vector<Look> looks_;
  std::size_t newest_ = 0;
};

}  // namespace lookout::csht
