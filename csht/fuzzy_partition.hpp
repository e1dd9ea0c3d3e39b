#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace lookout::csht {

/// A point of the plane of features, each axis in grid steps.
struct FeaturePoint {
  float x = 0.0F;  ///< First feature [grid steps].
  float y = 0.0F;  ///< Second feature [grid steps].
};

/// Points with weights, one for each cell of the vote matrix: it stands for the v'_ij equal sampling points
/// of [Yan2018] Eq. (18)-(20). Stored by component and padded with points of no weight to whole blocks.
class WeightedPoints {
 public:
  static constexpr int kBlock = 16;  ///< Points that are worked on together.

  void clear();                                      ///< Forgets all points and keeps the memory.
  void push_back(FeaturePoint point, float weight);  ///< Adds a point of weight >= 0; not after `pad`.
  void pad();  ///< Completes the last block; call after the last `push_back`.

  int size() const { return size_; }  ///< Without padding.
  /// Whole blocks, padding included after `pad`.
  int num_blocks() const { return static_cast<int>(x_.size()) / kBlock; }
  /// First features of a block, kBlock values.
  const float* x(int block) const { return x_.data() + first(block); }
  /// Second features of a block, kBlock values.
  const float* y(int block) const { return y_.data() + first(block); }
  /// Weights of a block, kBlock values.
  const float* weight(int block) const { return weight_.data() + first(block); }
  double total_weight() const { return total_weight_; }  ///< Sum of the weights.
  /// Weighted mean of the points; they must have weight.
  FeaturePoint mean() const;

 private:
  static std::ptrdiff_t first(int block) { return std::ptrdiff_t{block} * kBlock; }

  int size_ = 0;
  double total_weight_ = 0.0;
  std::vector<float> x_, y_, weight_;
};

/// What the class adjustment needs to know of one pattern.
struct PatternStatistics {
  double membership = 0.0;       ///< Sum of memberships, of [Yan2018] Eq. (24).
  double core_membership = 0.0;  ///< Q_i, sum of the memberships above theta. Eq. (31).
  double core_count = 0.0;       ///< T_i, the weight of the points that have one. Eq. (33).
  double deviation[2] = {0, 0};  ///< S_ij along x and y [grid steps]. Eq. (27).

  double aggregation() const { return core_count > 0.0 ? core_membership / core_count : 0.0; }  ///< C_i.
};

/// Weighted fuzzy c-means: memberships and centres. [Yan2018] Eq. (21)-(23).
class FuzzyPartition {
 public:
  /// @param fuzzifier m, > 1.
  explicit FuzzyPartition(double fuzzifier);

  /// Moves `centres` to the weighted means under their memberships, once. A point that lies on a centre
  /// belongs to it alone.
  /// @return how far the centre that moved most has moved [grid steps].
  float update(const WeightedPoints& points, std::span<FeaturePoint> centres);

  /// Statistics of the patterns, memberships above `theta` counted as the core; valid until the next call.
  std::span<const PatternStatistics> statistics(const WeightedPoints& points,
                                                std::span<const FeaturePoint> centres, double theta);

 private:
  using Lanes = Eigen::Array<float, WeightedPoints::kBlock, 1>;

  void affinities(const WeightedPoints& points, int block, std::span<const FeaturePoint> centres);
  void raise(Lanes& values) const;
  float move(std::span<FeaturePoint> centres) const;

  double fuzzifier_;
  bool squares_;                 ///< m = 2, where no power needs computing.
  std::vector<Lanes> affinity_;  ///< Of one block, a pattern each.
  Lanes scale_ = Lanes::Zero();  ///< Of one block.
  std::vector<Lanes> sums_;      ///< The sums of each pattern in a row.
  std::vector<PatternStatistics> statistics_;
};

}  // namespace lookout::csht
