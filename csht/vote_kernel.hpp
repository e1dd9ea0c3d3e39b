#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lookout::csht {

/// Votes are whole numbers of 1 / kVoteUnit, so that adding and removing a scan is exact.
inline constexpr int kVoteUnit = 256;

/// How one line sample votes in the cells of one row: `values[k]` for the k-th cell from `first` on.
struct Footprint {
  int first = 0;  ///< First cell, relative to the cell that holds the line sample's intercept.
  std::span<const std::int16_t> values;  ///< In units of 1/kVoteUnit vote; valid as long as the kernel.
};

/// Footprints of every width and every position of the intercept within its cell, computed once.
class VoteKernel {
 public:
  /// A Gaussian of widths (standard deviations, in cells) from `min_width` to `max_width`, both > 0.
  static VoteKernel gaussian(double min_width, double max_width);
  /// One whole vote in the cell that holds the intercept. [Yan2018] Eq. (16).
  static VoteKernel plain();

  static constexpr int kPhases = 16;  ///< Positions within a cell that are told apart.
  /// Footprints are a whole number of these many cells, so that they are added in full vectors.
  static constexpr int kLanes = 8;

  int width_index(double width) const;  ///< Of the nearest width below or at `width` [cells]; clamped.
  /// The footprint of a width at one of the kPhases positions; indices in range, unchecked.
  Footprint at(int width_index, int phase) const {
    const Width& width = widths_[static_cast<std::size_t>(width_index)];
    const std::size_t start = width.offset + static_cast<std::size_t>(phase * width.length);
    return {width.first, {values_.data() + start, static_cast<std::size_t>(width.length)}};
  }
  int max_length() const { return max_length_; }  ///< Cells of the widest footprint.

 private:
  struct Width {
    double width = 0.0;
    int first = 0;
    int length = 0;
    std::size_t offset = 0;  ///< Of phase 0 in values_.
  };
  void add_width(double width);

  std::vector<Width> widths_;
  std::vector<std::int16_t> values_;
  int max_length_ = 0;
};

}  // namespace lookout::csht
