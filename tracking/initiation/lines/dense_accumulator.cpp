#include "tracking/initiation/lines/dense_accumulator.hpp"

#include <algorithm>

namespace lookout::tracking {

void DenseAccumulator::reset(const LineGrid& grid) {
  votes_.assign(static_cast<std::size_t>(grid.num_cells()), 0);
}

int DenseAccumulator::most() const {
  const auto fullest = std::max_element(votes_.begin(), votes_.end());
  return fullest == votes_.end() ? 0 : *fullest;
}

void DenseAccumulator::collect(const LineGrid& grid, int least, std::size_t limit,
                               std::vector<LineVote>& found) const {
  for (std::size_t i = 0; i < votes_.size() && limit > 0; ++i) {
    if (votes_[i] < least) continue;
    found.push_back({grid.cell_at(static_cast<std::int64_t>(i)), static_cast<double>(votes_[i])});
    --limit;
  }
}

bool DenseAccumulator::is_local_maximum(const LineGrid& grid, const LineVote& vote) const {
  return tracking::is_local_maximum(grid, vote, [&](const LineCell& cell) { return votes(grid, cell); });
}

void ColumnVoting::vote(const LineGrid& grid, const Eigen::Vector2d& p, DenseAccumulator& votes) {
  if (normals_.size() != static_cast<std::size_t>(grid.num_theta())) {
    normals_.clear();
    for (int i = 0; i < grid.num_theta(); ++i) normals_.push_back(NormalLine{0.0, grid.theta_of(i)}.normal());
  }
  for (int i = 0; i < grid.num_theta(); ++i)
    votes.vote(grid, {i, grid.row_of(p.dot(normals_[static_cast<std::size_t>(i)]))});
}

}  // namespace lookout::tracking
