#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sonar_image.hpp"
#include "core/sonar_scan.hpp"

namespace lookout::tracking {

/// Knows the ring-down of a transducer that reports several returns a beam: the nearest return of most beams,
/// scan after scan, at one and the same short range. It is the sonar itself and says nothing of the sea, so
/// that what is as near is left out. A sonar of one return a beam shows it too, but there the beam has heard
/// nothing else: its returns stay.
class RingDown {
 public:
  static constexpr std::size_t kScans = 8;  ///< That are looked at,
  static constexpr int kFewestRinging = 5;  ///< of which so many must ring,
  static constexpr std::int64_t kFewestBehind =
      3;                                     ///< and hold so many returns behind others of their beams.
  static constexpr double kMostBeams = 0.5;  ///< Share of beams from which on a scan rings.
  static constexpr double kNear = 0.1;       ///< Of the maximum range, beyond which nothing rings.

  /// Takes the next scan; leaves out what rings. @param range_sigma within which the ring is sharp [m].
  /// @return how many returns were left out.
  std::int64_t drop(core::SonarScan& scan, double range_sigma);
  std::int64_t drop(core::SonarImage& image, double range_sigma);  ///< None: images have no returns.

 private:
  struct Seen {
    double edge = 0.0;        ///< Up to which it rings [m]; 0: it does not.
    std::int64_t behind = 0;  ///< Returns that have a nearer one in their beam.
  };
  Seen look_at(const core::SonarScan& scan, double range_sigma);
  double edge() const;

  std::array<Seen, kScans> seen_{};  ///< A ring of the newest.
  std::size_t count_ = 0;
  std::vector<double> nearest_;
  std::vector<char> heard_;
};

}  // namespace lookout::tracking
