#pragma once

#include <cstdint>
#include <vector>

#include "tracking/initiation/lines/line_grid.hpp"
#include "tracking/initiation/lines/peak_extraction.hpp"

namespace lookout::tracking {

/// Unit votes for every cell of a line grid, for methods that vote in each column. Two bytes a cell.
class DenseAccumulator {
 public:
  /// Takes the size of `grid` and forgets all votes; the memory is kept and only ever grows.
  void reset(const LineGrid& grid);

  /// One vote of a point with rho(theta) for the column of theta; off the grid it is left out.
  void vote(const LineGrid& grid, const LineCell& cell) {
    if (cell.rho >= 0 && cell.rho < grid.num_rho()) ++votes_[static_cast<std::size_t>(grid.index(cell))];
  }
  /// Votes of a cell on the grid.
  int votes(const LineGrid& grid, const LineCell& cell) const {
    return votes_[static_cast<std::size_t>(grid.index(cell))];
  }
  int most() const;  ///< Votes of the fullest cell, 0 where nothing voted.
  /// The first `limit` cells of at least `least` votes, appended to `found` in the order of the grid.
  void collect(const LineGrid& grid, int least, std::size_t limit, std::vector<LineVote>& found) const;
  /// Whether none of the eight cells around one of the collected votes holds more.
  bool is_local_maximum(const LineGrid& grid, const LineVote& vote) const;

 private:
  std::vector<std::uint16_t> votes_;
};

/// Every point votes once in every column, [Fan2018] section II. cos and sin of the columns are kept between
/// calls.
class ColumnVoting {
 public:
  /// Adds a point's votes, one a column; rows off the grid are left out.
  void vote(const LineGrid& grid, const Eigen::Vector2d& p, DenseAccumulator& votes);

 private:
  std::vector<Eigen::Vector2d> normals_;
};

}  // namespace lookout::tracking
