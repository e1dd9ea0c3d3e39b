#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csht/fuzzy_partition.hpp"

namespace lookout::csht {

/// The letters of [Yan2018] section III.B. Defaults: the set that works for every cell of the window tables.
struct FuzzyIsodataParams {
  double fuzzifier = 2.0;        ///< m of the memberships, > 1.
  double core_membership = 0.5;  ///< theta: a membership above it counts as the pattern's core, in [0, 1).
  double aggregation = 0.8;      ///< A: a pattern above it is compact, in [0, 1].
  double combination = 0.02;     ///< alpha_c: larger combines patterns farther apart, >= 0.
  double division_spread = 1.0;  ///< gamma: larger divides more as the patterns grow in number, >= 0.
  double division_step = 0.5;    ///< lambda_d: how far the halves are put apart, > 0.
  double deletion = 0.05;        ///< delta: smallest core, in shares of the mean pattern, >= 0.
  int rounds = 30;               ///< Rounds of class adjustment at most, > 0.
  int sweeps = 8;                ///< Updates of the centres between two adjustments at most, > 0.
  double at_rest = 0.02;         ///< Centres that move less are at rest [grid steps], > 0.
  double division_rounds = 2.0 / 3.0;  ///< Share of the rounds in which patterns may divide, in [0, 1].
};

/// Fuzzy ISODATA on weighted points: fuzzy c-means whose patterns are combined, divided and deleted.
/// [Yan2018] section III.B.
class FuzzyIsodata {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  explicit FuzzyIsodata(const FuzzyIsodataParams& params);

  /// Clusters `points` from the centres `first`; without a point or a centre there are no patterns.
  /// @return the centres of the patterns; valid until the next call.
  std::span<const FeaturePoint> cluster(const WeightedPoints& points, std::span<const FeaturePoint> first);

  /// Whether the last call came to rest: its centres at rest, and no pattern left to delete, combine or
  /// divide, not even one whose division came too late (`division_rounds`). True where there were no
  /// patterns.
  bool converged() const { return converged_; }

 private:
  enum class Adjustment { none, done };
  /// A feature of a pattern: 0 along x, 1 along y.
  struct Feature {
    std::size_t pattern = 0;
    int axis = 0;
    double deviation = 0.0;  ///< S_ij [grid steps].
  };

  bool update_to_rest(const WeightedPoints& points);  ///< Whether the sweeps brought the centres to rest.
  Adjustment adjust(const WeightedPoints& points, bool may_divide);
  Adjustment delete_one(double total_weight);
  Adjustment combine_closest();
  Adjustment divide_one();
  std::optional<Feature> widest() const;  ///< What must be divided first. Eq. (28)-(33).
  double division_threshold() const;      ///< F_std. Eq. (28).

  FuzzyIsodataParams params_;
  FuzzyPartition partition_;
  std::vector<FeaturePoint> centres_;
  std::span<const PatternStatistics> statistics_;
  bool converged_ = false;
};

}  // namespace lookout::csht
