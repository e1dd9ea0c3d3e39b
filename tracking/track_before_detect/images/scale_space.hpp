#pragma once

#include <Eigen/Core>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/matched_filter.hpp"
#include "tracking/track_before_detect/images/tail_law.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// How many cells of the frame, along columns and rows, make one cell of a scale.
struct CellScale {
  int columns = 1;  ///< A power of two.
  int rows = 1;     ///< A power of two.
  bool operator==(const CellScale&) const = default;
};

/// Which scales a frame is looked at in: a target's signature is one cell wide in one of them.
struct ScaleSpaceParams {
  /// Signature that is looked for [units of the geometry's cell size: m, rad; px]; 0: all up to the largest.
  Eigen::Vector2d signature{0, 0};
  Eigen::Vector2d largest{0.6, 0.035};  ///< Largest standard deviation of a signature [same units], > 0.
  int fewest_cells = 24;  ///< Along either axis of a pooled frame; coarser scales are left out, >= 1.
  bool same_on_both_axes = false;  ///< Whether only square cells are pooled, for pictures.
  MatchedFilterParams filter;      ///< Of the signature in the cells of each scale.
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const ScaleSpaceParams& params);

/// A frame in the cells of one scale.
struct ScaledFrame {
  explicit ScaledFrame(const MatchedFilterParams& params) : filter(params) {}  ///< Empty yet.

  CellScale scale;             ///< Its cells in those of the frame.
  IntensityFrame frame;        ///< Pooled, and standardised to median and spread of a Rayleigh amplitude.
  MatchedFilter filter;        ///< Of `frame`.
  TailLaw tail;                ///< Of the filter's blocks.
  TailLaw cells;               ///< Of the filter's single cells, a sample of them.
  std::vector<double> sample;  ///< That sample, ascending.
  double common = 0.0;         ///< Median of the ridge that noise alone makes, >= 0.
  /// By cell, deviation of what the filter gave there over the frames, over that of all cells; >= 1.
  /// Structure that fluctuates is brought to the level of the rest.
  std::vector<float> unrest;
  std::vector<float> power;         ///< By cell, mean square of what the filter gave, over that of all cells.
  double correlation = 1.0;         ///< Variance of the filtered frame over that of white cells, >= 1.
  double displayed_mean = 0.2;      ///< Power of a cell above the threshold, on average.
  double displayed_variance = 0.4;  ///< Of a cell whose power counts above the threshold alone.

  /// How many cells of another scale one of these covers along columns and rows.
  Eigen::Array2d cells_of(const ScaledFrame& other) const;
  /// A place of the frame in these cells.
  Eigen::Vector2d to_scale(const Eigen::Vector2d& cell) const;
  /// View of a place in these cells.
  CellView to_scale(CellView view) const;
  /// Filter's block maximum at a place of the frame, moved into it where it lies outside.
  double block_maximum_at(const Eigen::Vector2d& cell) const;
  /// ln of the probability that the block at a place of the frame is as bright without a target.
  double log_probability_at(const Eigen::Vector2d& cell) const;
};

/// Something bright and compact in one frame.
struct Candidate {
  int scale = 0;                 ///< Where it stands out most.
  Eigen::Vector2d cell{0, 0};    ///< Of the frame.
  double value = 0.0;            ///< Filtered amplitude.
  double log_probability = 0.0;  ///< ln of the probability of its block without a target, ridges allowed for.
};

/// One frame in all its scales, each pooled by two from the one before.
class ScaleSpace {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  /// @param threshold of displayed cells.
  ScaleSpace(const ScaleSpaceParams& params, double threshold);

  /// Takes a frame. Blocks of the windows, in cells of the frame, do not count as background.
  void apply(const IntensityFrame& frame, const Eigen::Vector2d& cell_size,
             const std::vector<CellWindow>& left_out);
  /// Learns how much the filter's output fluctuates in each cell, but for those of `kept`, in cells of the
  /// frame. After `apply`.
  void learn(const std::vector<CellWindow>& kept);
  /// Overwrites `candidates` with the peaks of all scales of which fewer than `expected` a frame and scale
  /// are expected without targets, each place once, the least probable first, `most` at most.
  void find(double expected, std::size_t most, std::vector<Candidate>& candidates);

  const std::vector<ScaledFrame>& scales() const { return scales_; }  ///< Of the frame at hand.
  /// Whether the last frame changed which scales there are.
  bool changed() const { return changed_; }
  /// ln of the probability that a cell of a scale is as bright without a target: on a ridge, whichever way it
  /// runs, as one among cells of the ridge's own level. A ridge is what lies above that of noise alone.
  double cell_log_probability(const ScaledFrame& scaled, int column, int row) const;
  /// Standard deviation of the signature of a scale [cells of the frame].
  Eigen::Vector2d signature(std::size_t scale) const;
  /// The scale whose signature is nearest to `sigma` [cells of the frame].
  int nearest(const Eigen::Vector2d& sigma) const;
  const ScaleSpaceParams& params() const { return params_; }  ///< As given.

 private:
  void lay_out(const IntensityFrame& frame, const Eigen::Vector2d& cell_size);
  bool wanted(const Eigen::Vector2d& sigma, const Eigen::Vector2d& cell_size) const;
  void pool(const IntensityFrame& frame);
  void to_scale(const std::vector<CellWindow>& windows, const CellScale& scale);
  void tile(const std::vector<CellWindow>& left_out);
  double above_ridge(const MatchedFilter& filter, const FramePeak& peak) const;
  double ridge(const MatchedFilter& filter, int column, int row) const;

  ScaleSpaceParams params_;
  double threshold_;
  std::vector<ScaledFrame> scales_;
  std::vector<IntensityFrame> pooled_;
  int columns_ = 0, rows_ = 0;
  Eigen::Vector2d cell_size_{0, 0};
  bool changed_ = false;
  int learnt_ = 0;  ///< Frames, up to the memory.
  std::vector<char> held_;
  std::vector<double> sample_;
  std::vector<FramePeak> peaks_;
  std::vector<Candidate> found_;
  std::vector<CellWindow> windows_;
};

}  // namespace lookout::tracking
