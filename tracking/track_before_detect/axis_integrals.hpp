#pragma once

#include <vector>

namespace lookout::tracking {

/// Closed-form integrals of a normal density N(mean, variance) over the cells [i, i + 1) of one image axis.
/// Moments are about the density's own mean. [Pakfiliz2018] Eq. (6), (11), (21) per axis, none divided by the
/// probability, which underflows beyond some 38 standard deviations.
struct CellIntegrals {
  double probability = 0.0;  ///< Integral of N, in [0, 1].
  double first = 0.0;        ///< Integral of (tau - mean) N [cells].
  double second = 0.0;       ///< Integral of (tau - mean)^2 N [cells^2], >= 0.
};

/// The integrals over [low, high), low < high; variance > 0.
CellIntegrals integrate_cell(double mean, double variance, double low, double high);

/// The three integrals one by one, as the printed algorithm evaluates them in every cell.
double cell_probability(double mean, double variance, double low, double high);
/// CellIntegrals::first alone.
double cell_first_moment(double mean, double variance, double low, double high);
/// CellIntegrals::second alone.
double cell_second_moment(double mean, double variance, double low, double high);

/// Which integrals are evaluated.
enum class CellMoments {
  first,  ///< Probability and first moment.
  second  ///< The second moment too.
};

/// The integrals over a run of neighbouring cells: one error function and one exponential an edge. Cells with
/// a probability below 1e-150 hold 0.
class AxisIntegrals {
 public:
  /// Cells [first_cell, first_cell + num_cells); num_cells >= 0, variance > 0. Keeps its buffers. Moments
  /// that are not evaluated hold 0.
  void compute(double mean, double variance, int first_cell, int num_cells,
               CellMoments moments = CellMoments::second);

  /// Of each cell, from the first on.
  const std::vector<double>& probability() const { return probability_; }
  const std::vector<double>& first() const { return first_; }    ///< First moments of each cell.
  const std::vector<double>& second() const { return second_; }  ///< Second moments of each cell.
  const CellIntegrals& sum() const { return sum_; }              ///< Of all the cells.

 private:
  std::vector<double> probability_, first_, second_;
  CellIntegrals sum_;
};

}  // namespace lookout::tracking
