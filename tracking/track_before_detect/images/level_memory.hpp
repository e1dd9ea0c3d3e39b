#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lookout::tracking {

/// How a ping enters a memory of levels.
struct MemoryRates {
  float most_pings = 100.0f;  ///< Pings that a cell remembers, >= 1.
  float swift_share = 1.0f;   ///< Of a ping in the swift memory, in (0, 1].
  float most_kept = 1e6f;     ///< Pings on end that a cell may be kept for a target, >= 0; then it is learnt.
};

/// What the cells of an image have held over their usual level, in one frame: that of the sonar, or, where it
/// is moved with the sonar, that of the earth.
class LevelMemory {
 public:
  static constexpr std::uint32_t kNew = 0xffffffffu;  ///< A cell that was not in the image before.

  void begin(std::size_t cells);  ///< Forgets all; so many cells from now on.
  /// What is expected of a cell, in units of its usual level, which counts for `prior` pings, > 0.
  float level(std::size_t cell, float prior) const {
    return (prior + count_[cell] * mean_[cell]) / (prior + count_[cell]);
  }
  /// A ping held `ratio` times the usual level in a cell that no target covers.
  void learn(std::size_t cell, float ratio, const MemoryRates& rates);
  /// The same of a cell that a target may cover: only the swift memory learns it, until it has been kept too
  /// long, for a target passes.
  void keep(std::size_t cell, float ratio, const MemoryRates& rates);
  /// The same of a cell that was found to stand: from now on what the swift memory holds is its level.
  void stand(std::size_t cell, float ratio, const MemoryRates& rates);
  /// Takes each cell from where it was: by cell, the index that it had, or kNew.
  void move(const std::vector<std::uint32_t>& from);

 private:
  void glance(std::size_t cell, float ratio, const MemoryRates& rates);

  std::vector<float> mean_, count_, swift_;  ///< By cell: memory, its pings, swift memory.
  std::vector<float> kept_;                  ///< By cell, pings on end for which it was kept.
  std::vector<float> moved_;
};

}  // namespace lookout::tracking
