#include "tracking/association/track_to_element.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

/// Mean variance of the two axes that begin at `first`: 0 position [m^2], 2 velocity [m^2/s^2].
double variance(const core::Track& track, const core::MotionElement& element, int first) {
  return 0.5 * (track.covariance.diagonal().segment<2>(first).sum() +
                element.covariance.diagonal().segment<2>(first).sum());
}

}  // namespace

void ElementGate::validate() const {
  core::require(position > 0.0, "element gate: position must be > 0", position);
  core::require(velocity > 0.0, "element gate: velocity must be > 0", velocity);
  core::require_not_negative("element gate: sigmas", sigmas);
}

TrackToElement::TrackToElement(const ElementGate& gate) : gate_(gate) {
  gate_.validate();
}

const std::vector<int>& TrackToElement::assign(std::span<const core::Track> tracks,
                                               std::span<const core::MotionElement> elements) {
  element_of_track_.assign(tracks.size(), -1);
  if (tracks.empty() || elements.empty()) return element_of_track_;
  const auto rows = static_cast<Eigen::Index>(tracks.size());
  const auto columns = static_cast<Eigen::Index>(elements.size());
  // Grown in steps that double, so that a warm caller allocates nothing.
  if (cost_.rows() < rows || cost_.cols() < columns)
    cost_.resize(std::max(2 * rows, cost_.rows()), std::max(2 * columns, cost_.cols()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j)
      cost_(i, j) = cost(tracks[static_cast<std::size_t>(i)], elements[static_cast<std::size_t>(j)]);
  }
  const auto& element_of_row = solver_.solve(cost_.topLeftCorner(rows, columns));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int element = element_of_row[static_cast<std::size_t>(i)];
    if (element >= 0 && cost_(i, element) < 1.0) element_of_track_[static_cast<std::size_t>(i)] = element;
  }
  return element_of_track_;
}

double TrackToElement::cost(const core::Track& track, const core::MotionElement& element) const {
  const double spread = gate_.sigmas * gate_.sigmas;
  const double position = gate_.position * gate_.position + spread * variance(track, element, 0);
  const double velocity = gate_.velocity * gate_.velocity + spread * variance(track, element, 2);
  // At the gate a pair costs as much as leaving both alone.
  return std::min(1.0, (track.position() - element.position).squaredNorm() / position +
                           (track.velocity() - element.velocity).squaredNorm() / velocity);
}

}  // namespace lookout::tracking
