#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Shape of the filter and of the neighbourhood in which one maximum counts.
struct MatchedFilterParams {
  Eigen::Vector2d sigma{1.1, 0.75};  ///< Of the Gaussian filter along columns and rows [cells], > 0.
  int block_columns = 5;             ///< Odd, >= 1.
  int block_rows = 3;                ///< Odd, >= 1.
};

/// One local maximum of the filtered frame.
struct FramePeak {
  int column = 0;      ///< Of the cell.
  int row = 0;         ///< Of the cell.
  double value = 0.0;  ///< Filtered amplitude.
};

/// The frame filtered with the instrument's signature, and where one value stands among all others. The rank
/// of a block's maximum among the maxima of the blocks that tile the frame needs no law of the background.
class MatchedFilter {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit MatchedFilter(const MatchedFilterParams& params = {});

  /// Filters a frame; the tiling leaves out the blocks whose centre lies in one of the windows.
  /// @param divisors of each filtered cell, > 0; empty: all 1.
  void apply(const IntensityFrame& frame, std::span<const CellWindow> left_out = {},
             std::span<const float> divisors = {});

  /// Filtered amplitude of a cell.
  double at(int column, int row) const { return filtered_[index(column, row)]; }
  /// Maximum of the block centred on the cell (clipped at the border).
  double block_maximum(int column, int row) const { return maximum_[index(column, row)]; }
  /// The value that a share `quantile` of the tiling blocks lies below.
  double quantile(double quantile) const;
  /// Overwrites `peaks` with the cells that are the maximum of their own block and exceed `threshold`, the
  /// strongest first.
  void find_peaks(double threshold, std::vector<FramePeak>& peaks) const;

  /// Where a peak lies between the cells [cells, centres at .5]: the tops of the parabolas through its value
  /// and those of its neighbours, along columns and along rows; at the border its cell's own centre.
  Eigen::Vector2d place_of(const FramePeak& peak) const;

  const std::vector<double>& filtered() const { return filtered_; }  ///< Row by row.
  std::span<const double> tiles() const { return tiles_; }  ///< Maxima of the tiling blocks, ascending.
  /// Filtered amplitude that a constant frame of level 1 would have, its mean not being taken off.
  double gain() const { return gain_; }
  const MatchedFilterParams& params() const { return params_; }  ///< As given.

  int columns() const { return columns_; }  ///< Of the frame at hand.
  int rows() const { return rows_; }        ///< Of the frame at hand.

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  void filter_rows(const IntensityFrame& frame);
  void filter_columns();
  void find_maxima();
  void tile(std::span<const CellWindow> left_out);

  MatchedFilterParams params_;
  int columns_ = 0, rows_ = 0;
  double gain_ = 1.0;
  std::vector<double> kernel_x_, kernel_y_;
  std::vector<double> scratch_, filtered_, maximum_;
  std::vector<double> tiles_;  ///< Maxima of the tiling blocks, ascending.
};

}  // namespace lookout::tracking
