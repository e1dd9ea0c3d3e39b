#include "fusion/fusion_clock.hpp"

#include <algorithm>
#include <cmath>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::fusion {

FusionClock::FusionClock(const FusionClockParams& params) : params_(params) {
  core::require_positive("clock_tolerance", params.tolerance);
  core::require(params.consistent >= 1, "consistent must be >= 1", params.consistent);
}

bool FusionClock::close(std::int64_t a, std::int64_t b) const {
  // In floating point, for two wild stamps may be farther apart than an integer holds.
  return std::abs(static_cast<double>(a) - static_cast<double>(b)) <= params_.tolerance * 1e6;
}

std::int64_t FusionClock::offset(std::int32_t node_id) const {
  const auto found = nodes_.find(node_id);
  return found == nodes_.end() ? 0 : found->second.offset;
}

FusionClock::Reading FusionClock::read(std::int32_t node_id, std::int64_t utime) {
  Node& node = nodes_[node_id];
  if (!now_) now_ = utime;
  if (close(utime, *now_ - node.offset)) return accept(node, node_id, utime + node.offset);
  const bool fits = node.outliers > 0 && close(utime, node.outlier);
  node.alone = fits ? node.alone : true;
  node.outliers = fits ? node.outliers + 1 : 1;
  node.outlier = utime;
  if (node.outliers < params_.consistent) return {};
  return settle(node, node_id, utime);
}

FusionClock::Reading FusionClock::accept(Node& node, std::int32_t node_id, std::int64_t utime) {
  node.outliers = 0;
  now_ = std::max(*now_, utime);
  for (auto& [id, other] : nodes_) {
    if (id != node_id) other.alone = false;
  }
  return {utime, false};
}

FusionClock::Reading FusionClock::settle(Node& node, std::int32_t node_id, std::int64_t utime) {
  if (!node.alone) {
    node.offset = *now_ - utime;
    return accept(node, node_id, *now_);
  }
  const bool backwards = utime + node.offset < *now_;
  if (backwards) {
    nodes_.clear();
    now_ = utime;
    return {accept(nodes_[node_id], node_id, utime).utime, true};
  }
  now_ = utime + node.offset;
  return accept(node, node_id, *now_);
}

}  // namespace lookout::fusion
