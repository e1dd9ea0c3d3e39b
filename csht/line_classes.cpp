#include "csht/line_classes.hpp"

#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

/// Features in grid steps about `centre`, so that an error of one step counts the same along either axis.
FeaturePoint feature_of(const VoteCell& cell, const HoughGrid& grid, double centre) {
  return {static_cast<float>(cell.velocity / grid.velocity_step),
          static_cast<float>((cell.intercept - centre) / grid.intercept_step)};
}

}  // namespace

LineClasses::LineClasses(const LineClassesParams& params) : params_(params), isodata_(params.isodata) {
  params.threshold.validate();
  core::require(params.max_first >= 1, "max_first must be > 0", params.max_first);
  core::require_not_negative("first_apart", params.first_apart);
}

std::span<const Line> LineClasses::find(const HoughSpace& space, double time, double centre) {
  keep_cells(space, time, centre);
  strongest_apart(cells_, space.grid(), params_.first_apart, params_.max_first, peaks_);
  to_features(space.grid(), centre);
  lines_.clear();
  const auto patterns =
      params_.cluster ? isodata_.cluster(points_, first_) : std::span(std::as_const(first_));
  for (const auto& pattern : patterns)
    lines_.push_back({static_cast<double>(pattern.x) * space.grid().velocity_step,
                      static_cast<double>(pattern.y) * space.grid().intercept_step + centre});
  return lines_;
}

void LineClasses::keep_cells(const HoughSpace& space, double time, double centre) {
  threshold_ = primary_threshold(params_.threshold, space.statistics());
  space.cells_above(threshold_, time, centre, cells_);
  sort_by_votes(cells_);
}

void LineClasses::to_features(const HoughGrid& grid, double centre) {
  points_.clear();
  for (const auto& cell : cells_)
    points_.push_back(feature_of(cell, grid, centre), static_cast<float>(cell.votes));
  points_.pad();
  first_.clear();
  for (const auto& peak : peaks_) first_.push_back(feature_of(peak, grid, centre));
}

}  // namespace lookout::csht
