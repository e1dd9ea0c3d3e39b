#pragma once

#include <algorithm>
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
  /// The level of a Rayleigh amplitude that is as rarely far above it as one that has, with this cell's
  /// share, the level that either memory expects. What is expected to be loud with some probability is no
  /// target.
  float level(int column, int row, float moved, float still) const {
    const std::size_t block = block_of(column, row);
    return std::max(moved_weight_[block] * moved, still_weight_[block] * still);
  }

 private:
  static constexpr int kBlockColumns = 16, kBlockRows = 4;  // cells; structure and its shadow lie along beams
  void weigh(std::size_t block);
  std::size_t block_of(int column, int row) const {
    return static_cast<std::size_t>(row / kBlockRows) * across_ +
           static_cast<std::size_t>(column / kBlockColumns);
  }

  std::size_t across_ = 0;
  int columns_ = 0;
  std::vector<float> evidence_;  ///< By block, ln of how much better the moved memory foretells.
  std::vector<float> share_;     ///< By block.
  std::vector<float> moved_weight_, still_weight_;  ///< By block, of either memory's level, in [0, 1].
};

}  // namespace lookout::tracking
