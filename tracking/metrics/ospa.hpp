#pragma once

#include <Eigen/Core>
#include <span>

#include "tracking/metrics/power_assignment.hpp"

namespace lookout::tracking {

/// Order and cut-off of the OSPA distance. Defaults: [Yan2018] Eq. (42).
struct OspaParams {
  double cutoff =
      20.0;  ///< Largest distance that counts, and the price of a wrong count [m or m/s], > 0, finite.
  double order = 2.0;  ///< Order p, >= 1; infinite: the worst pair counts alone, a wrong count the cut-off.
};

/// The OSPA distance of two sets and its parts: total^p = localization^p + cardinality^p.
struct OspaResult {
  double total = 0.0;         ///< [m].
  double localization = 0.0;  ///< Of the pairs' distances [m].
  double cardinality = 0.0;   ///< Of the difference in number [m].
  int num_truth = 0;          ///< Size of the true set.
  int num_tracks = 0;         ///< Size of the estimated set.
};

/// Optimal sub-pattern assignment distance between two finite sets of points of the plane (positions or
/// velocities), sets of hundreds included. [Schuhmacher2008] Eq. (3); [Yan2018] Eq. (42)-(46). Keeps its
/// buffers.
class Ospa {
 public:
  /// @throws std::invalid_argument on a cut-off that is not finite and above 0 or an order < 1.
  explicit Ospa(const OspaParams& params = {});

  /// Both sets empty: 0; one empty: the cut-off, all of it cardinality.
  OspaResult operator()(std::span<const Eigen::Vector2d> truth, std::span<const Eigen::Vector2d> estimate);

  /// The same of two sets whose distances, each at most the cut-off, are known: a row each of the truth's
  /// members, a column each of the estimate's.
  OspaResult of_distances(const Eigen::MatrixXd& distance);

  const OspaParams& params() const { return params_; }  ///< As given.

 private:
  void fill_distances(std::span<const Eigen::Vector2d> truth, std::span<const Eigen::Vector2d> estimate);

  OspaParams params_;
  PowerAssignment assignment_;
  Eigen::MatrixXd distance_;
};

}  // namespace lookout::tracking
