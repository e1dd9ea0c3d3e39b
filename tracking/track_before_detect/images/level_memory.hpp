#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lookout::tracking {

/// How a ping enters a memory of levels.
struct MemoryRates {
  float most_pings = 100.0f;  ///< Pings that a cell remembers, >= 1.
  float swift_share = 1.0f;   ///< Of a ping in the swift memory, in (0, 1].
};

/// What the cells of an image have held over their usual level, in one frame: that of the sonar, or, where it
/// is moved with the sonar, that of the earth.
class LevelMemory {
 public:
  void begin(std::size_t cells);  ///< Forgets all; so many cells from now on.
  /// What is expected of a cell, in units of its usual level.
  /// @param prior pings that `usual` counts for, > 0.
  /// @param usual expected of a cell of which nothing is known.
  float level(std::size_t cell, float prior, float usual = 1.0f) const {
    return (prior * usual + count_[cell] * mean_[cell]) / (prior + count_[cell]);
  }
  /// A ping held `ratio` times the usual level in a cell that no target covers.
  void learn(std::size_t cell, float ratio, const MemoryRates& rates);
  /// The same of a cell that a target may cover: only the swift memory learns it, until it has been kept too
  /// long, for a target passes; then it is learnt with all that it held. Each ping that it is free takes one
  /// off.
  /// @param most_kept pings for which it may be kept, >= 0.
  void keep(std::size_t cell, float ratio, float most_kept, const MemoryRates& rates);
  /// The same of a cell that was found to stand: from now on what the swift memory holds is its level.
  void stand(std::size_t cell, float ratio, const MemoryRates& rates);
  /// Takes each cell of an image of so many columns from where it was.
  /// @param from by cell, place in the image before, cell centres at whole numbers; outside it, a cell
  /// is new.
  void move(const std::vector<Eigen::Vector2f>& from, int columns);

 private:
  void glance(std::size_t cell, float ratio, const MemoryRates& rates);
  void take_in(std::size_t cell, float ratio, float pings, const MemoryRates& rates);
  std::uint32_t source_of(const Eigen::Vector2f& from, int columns, int rows) const;

  std::vector<float> mean_, count_, swift_;  ///< By cell: memory, its pings, swift memory.
  std::vector<float> kept_, held_;  ///< By cell, pings for which it was kept of late, and their mean.
  /// By cell, where what it remembers lies beyond its centre, along columns and rows [cells]: moves are to
  /// whole cells.
  std::vector<Eigen::Vector2f> drift_;
  std::vector<float> moved_;
  std::vector<Eigen::Vector2f> moved_drift_;
  std::vector<std::uint32_t> source_;
};

}  // namespace lookout::tracking
