#pragma once

#include <cstddef>
#include <vector>

#include "tracking/track_before_detect/images/level_memory.hpp"

namespace lookout::tracking {

/// What a memory in the sonar's frame holds over many beams. What stands there, a bottom, a ring or the
/// surface, spans much of the fan; the echo of a target, which may go along with the sonar, spans the few
/// beams of its point spread alone.
class WideLevel {
 public:
  /// Every cell of an image of bins x beams is at its usual level.
  void begin(int bins, int beams);
  /// The echo of a point spans so many beams between its nulls; 3 at least, and until this is called.
  void widen(double beams);
  /// Takes in the memory after a ping: about 300 operations for every 16th cell, in the first pings every
  /// 4th.
  /// @param prior pings that the usual level counts for, > 0.
  void update(const LevelMemory& memory, float prior);
  /// The upper quartile over the beams around, which shadows on some of them leave alone, in units of the
  /// usual level.
  float at(int bin, int beam) const { return level_[index(bin, beam)]; }

 private:
  static constexpr int kStep = 4;  // beams that share a quartile, pings in which each bin has its turn
  std::size_t index(int bin, int beam) const {
    return static_cast<std::size_t>(beam / kStep) * static_cast<std::size_t>(bins_) +
           static_cast<std::size_t>(bin);
  }
  float quartile_around(const LevelMemory& memory, float prior, int bin, int beam);

  int bins_ = 0, beams_ = 0, window_ = 0, pings_ = 0;
  std::vector<float> level_;   ///< By group of beams and bin.
  std::vector<float> values_;  ///< Of one window.
};

}  // namespace lookout::tracking
