#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/sonar_scan.hpp"

namespace lookout::tracking {

/// Tells a sonar that reports several returns a beam from one that reports one, as [Yan2018] has it. No
/// message says which it is, and a likelihood of one return a beam hears the nearest alone.
class SeveralReturns {
 public:
  static constexpr std::size_t kScans = 12;  ///< Of a sensor that are looked at,
  static constexpr int kFewest = 9;  ///< of which so many must hold a return behind another of its beam,
  static constexpr double kLeastShare = 0.01;  ///< and more than this share of such ones. Less is chance at
                                               ///< the edges of beams.

  /// Takes the next accepted scan. @return the mean number of returns of this sensor's newest scans, once:
  /// where several returns a beam have become its habit.
  std::optional<double> learn(const core::SonarScan& scan);

 private:
  struct Seen {
    bool several = false;
    double returns = 0.0;
  };
  struct Sensor {
    std::array<Seen, kScans> seen{};  ///< A ring.
    std::size_t count = 0;
  };

  bool told_ = false;
  std::map<std::int32_t, Sensor> sensors_;
  std::vector<char> heard_;
};

}  // namespace lookout::tracking
