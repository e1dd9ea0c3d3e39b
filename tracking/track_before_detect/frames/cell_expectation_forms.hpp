#pragma once

#include <memory>

#include "tracking/track_before_detect/axis_integrals.hpp"
#include "tracking/track_before_detect/frames/cell_expectation.hpp"

/// What the four forms of the E-step share; an implementation detail of make_cell_expectation.
namespace lookout::tracking {

/// Cell by cell with each integral anew, as printed.
std::unique_ptr<CellExpectation> make_per_cell_expectation(Truncation truncation);
/// With the integrals of rows and columns computed once.
std::unique_ptr<CellExpectation> make_separable_expectation(Truncation truncation);
/// With the displayed cells alone.
std::unique_ptr<CellExpectation> make_sparse_expectation(Truncation truncation);
/// With the displayed cells inside each target's gate.
std::unique_ptr<CellExpectation> make_gated_expectation(const GateParams& gate);

/// The integrals of one model along both axes, from the first cell of either on.
struct ModelAxes {
  AxisIntegrals x, y;    ///< Along columns and along rows.
  int first_column = 0;  ///< Column of the first integral of `x`.
  int first_row = 0;     ///< Row of the first integral of `y`.

  /// Index of a column in `x`.
  std::size_t column(int c) const { return static_cast<std::size_t>(c - first_column); }
  /// Index of a row in `y`.
  std::size_t row(int r) const { return static_cast<std::size_t>(r - first_row); }

  /// Cell probability of Eq. (6).
  double probability(int c, int r) const { return x.probability()[column(c)] * y.probability()[row(r)]; }

  /// Adds `weight` times the integrals of one cell to the sums.
  void add(int c, int r, double weight, TargetSums& sums) const {
    add(weight, {x.probability()[column(c)], x.first()[column(c)], x.second()[column(c)]},
        {y.probability()[row(r)], y.first()[row(r)], y.second()[row(r)]}, sums);
  }
  /// Adds `weight` times the integrals over all the cells.
  void add_all(double weight, TargetSums& sums) const { add(weight, x.sum(), y.sum(), sums); }

  /// Probability that all the cells hold together.
  double mass() const { return x.sum().probability * y.sum().probability; }

  /// The product form of a diagonal covariance: 2-D moments from those along the axes.
  static void add(double weight, const CellIntegrals& in_x, const CellIntegrals& in_y, TargetSums& sums) {
    sums.responsibility += weight * in_x.probability * in_y.probability;
    sums.first.x() += weight * in_x.first * in_y.probability;
    sums.first.y() += weight * in_x.probability * in_y.first;
    sums.second.x() += weight * in_x.second * in_y.probability;
    sums.second.y() += weight * in_x.probability * in_y.second;
  }
};

/// The cells of a frame and what is wanted of them.
struct FrameCells {
  int columns = 0;                            ///< Of the frame.
  int rows = 0;                               ///< Of the frame.
  CellMoments moments = CellMoments::second;  ///< See CellMoments.
};

/// The axes of every model over a whole frame; starts the sums of `result`. @return integrals evaluated.
std::int64_t compute_axes(std::span<const CellModel> models, const FrameCells& cells,
                          std::vector<ModelAxes>& axes, Expectation& result);

}  // namespace lookout::tracking
