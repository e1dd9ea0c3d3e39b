#pragma once

#include <cstddef>
#include <vector>

namespace lookout::tracking {

/// Which of two memories foretells the image better, by place: what stands on the earth is foretold by the
/// one that moves with the sonar, the bottom and the instrument's own marks by the one that does not. The
/// evidence is that of a Rayleigh amplitude, summed over blocks of cells and faded over the pings.
class MemoryChoice {
 public:
  /// Forgets all; the image has so many columns and rows from now on.
  void begin(int columns, int rows);
  /// Takes a ping's row of ratios to the usual level beside what either memory expected, all > 0.
  void add(int row, const float* ratio, const float* moved, const float* still);
  /// Once a ping, after its rows: turns the evidence into shares.
  void settle();
  /// Share of the moved memory at a cell, in [0, 1]; .88 before any evidence.
  float share(int column, int row) const { return share_[block_of(column, row)]; }

 private:
  static constexpr int kBlock = 16;  // cells along either axis
  std::size_t block_of(int column, int row) const {
    return static_cast<std::size_t>(row / kBlock) * across_ + static_cast<std::size_t>(column / kBlock);
  }

  std::size_t across_ = 0;
  int columns_ = 0;
  std::vector<float> evidence_;  ///< By block, ln of how much better the moved memory foretells.
  std::vector<float> share_;     ///< By block.
};

}  // namespace lookout::tracking
