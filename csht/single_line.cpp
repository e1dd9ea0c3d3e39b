#include "csht/single_line.hpp"

#include <algorithm>
#include <utility>

#include "core/parameter_check.hpp"
#include "csht/vote_peaks.hpp"

namespace lookout::csht {

SingleLine::SingleLine(const SingleLineParams& params, HoughSpace space)
    : params_(params), space_(std::move(space)) {
  core::require_share_below_one("peak_share", params.peak_share);
  core::require_not_negative("radius", params.radius);
}

std::optional<Line> SingleLine::extract(std::span<const LineSample> samples, double time, double centre) {
  if (samples.empty()) return std::nullopt;
  space_.clear();
  space_.add(samples);
  space_.cells_above(params_.peak_share * space_.statistics().peak, time, centre, cells_);
  if (cells_.empty()) return std::nullopt;
  const VoteCell peak = *std::max_element(cells_.begin(), cells_.end(),
                                          [](const auto& a, const auto& b) { return a.votes < b.votes; });
  Line line;
  double weight = 0.0;
  for (const auto& cell : cells_) {
    if (steps_apart(cell, peak, space_.grid()) > params_.radius) continue;
    line.velocity += cell.votes * cell.velocity;
    line.intercept += cell.votes * cell.intercept;
    weight += cell.votes;
  }
  return Line{line.velocity / weight, line.intercept / weight};
}

}  // namespace lookout::csht
