#pragma once

#include <span>
#include <vector>

#include "csht/fuzzy_isodata.hpp"
#include "csht/hough_space.hpp"
#include "csht/line_sample.hpp"
#include "csht/vote_peaks.hpp"

namespace lookout::csht {

/// How the clusters of a vote matrix are found.
struct LineClassesParams {
  PrimaryThresholdParams threshold;  ///< Of the cells that are clustered.
  FuzzyIsodataParams isodata;        ///< Of the clustering.
  double first_apart = 3.0;          ///< Least distance of two first classes [grid steps], >= 0.
  int max_first = 20;                ///< K0, most first classes, > 0.
  bool cluster = true;               ///< False: the first classes as they are, without fuzzy ISODATA.
};

/// The clustering statistic of one vote matrix: cells above the primary threshold, first classes at their
/// peaks, fuzzy ISODATA. [Yan2018] Eq. (17)-(38).
class LineClasses {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit LineClasses(const LineClassesParams& params);

  /// The classes as lines through intercept at `time` [s]; intercepts lie around `centre` [m]. Valid until
  /// the next call.
  std::span<const Line> find(const HoughSpace& space, double time, double centre);

  /// The cells that the last call kept, by falling votes, and its threshold [votes].
  std::span<const VoteCell> kept_cells() const { return cells_; }
  double threshold() const { return threshold_; }  ///< Of the last call [votes].

 private:
  void keep_cells(const HoughSpace& space, double time, double centre);
  void to_features(const HoughGrid& grid, double centre);

  LineClassesParams params_;
  FuzzyIsodata isodata_;
  double threshold_ = 0.0;
  std::vector<VoteCell> cells_;
  std::vector<VoteCell> peaks_;
  WeightedPoints points_;
  std::vector<FeaturePoint> first_;
  std::vector<Line> lines_;
};

}  // namespace lookout::csht
