#include "fusion/fusion_clock.hpp"

#include <algorithm>
#include <cmath>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

constexpr double kGain = 0.2;       // Of a new interval or delay in the running means: five or so count.
constexpr double kSteps = 2.0;      // Intervals that one lost message makes of one.
constexpr double kJudgement = 5.0;  // Messages' worth of evidence that decides.

/// From `b` to `a` [s]; in floating point, for two wild stamps may be farther apart than an integer holds.
double apart(std::int64_t a, std::int64_t b) {
  constexpr double kMicro = 1e-6;
  return kMicro * (static_cast<double>(a) - static_cast<double>(b));
}

void blend(double& mean, double value) {
  mean += (mean > 0.0 ? kGain : 1.0) * (value - mean);
}

}  // namespace

FusionClock::FusionClock(const FusionClockParams& params) : params_(params) {
  core::require_positive("clock_tolerance", params.tolerance);
  core::require(params.max_delay >= params.tolerance, "max_delay must be >= clock_tolerance",
                params.max_delay);
  core::require_positive("max_interval", params.max_interval);
  core::require(params.max_nodes >= 1, "max_nodes must be >= 1", static_cast<double>(params.max_nodes));
  core::require(params.consistent >= 1, "consistent must be >= 1", params.consistent);
}

std::int64_t FusionClock::offset(std::int32_t node_id) const {
  const auto found = nodes_.find(node_id);
  return found == nodes_.end() ? 0 : found->second.offset;
}

double FusionClock::delay(std::int32_t node_id) const {
  const auto found = nodes_.find(node_id);
  return found == nodes_.end() ? 0.0 : found->second.delay;
}

FusionClock::Reading FusionClock::read(std::int32_t node_id, std::int64_t utime) {
  if (!has_room_for(node_id)) return {std::nullopt, false, true};
  Node& node = nodes_[node_id];
  if (!now_) now_ = utime;
  if (fits(node, utime)) return accept(node, node_id, utime + node.offset);
  note_outlier(node, utime);
  if (another_agrees(node_id, node, utime)) return pass_time(node, node_id, utime + node.offset);
  if (node.outliers < params_.consistent) return {};
  return settle(node, node_id, utime);
}

/// For a new node one is forgotten that never kept time, or that has been silent for long.
bool FusionClock::has_room_for(std::int32_t node_id) {
  if (nodes_.size() < params_.max_nodes || nodes_.contains(node_id)) return true;
  const auto oldest = std::min_element(nodes_.begin(), nodes_.end(), [](const auto& a, const auto& b) {
    return a.second.newest < b.second.newest;  // None comes first.
  });
  const auto& newest = oldest->second.newest;
  if (newest && apart(*now_, *newest) <= params_.max_interval) return false;
  nodes_.erase(oldest);
  return true;
}

/// Not behind its own newest by more than clocks differ, not older than links delay, not farther ahead than
/// clocks differ or its own rate explains.
bool FusionClock::fits(const Node& node, std::int64_t utime) const {
  const double shift = apart(node.offset, 0);
  const double ahead = apart(utime, *now_) + shift;
  if (-ahead > params_.max_delay) return false;
  if (!node.newest) return ahead <= params_.tolerance;
  const double step = apart(utime, *node.newest) + shift;
  if (step < -params_.tolerance) return false;
  return ahead <= params_.tolerance || step <= kSteps * node.interval;
}

void FusionClock::note_outlier(Node& node, std::int64_t utime) {
  node.step = apart(utime, node.outlier);
  const bool goes_on =
      node.outliers > 0 && node.step >= -params_.tolerance && node.step <= params_.max_interval;
  node.alone = goes_on ? node.alone : true;
  node.outliers = goes_on ? node.outliers + 1 : 1;
  node.outlier = utime;
}

/// Whether the newest outlier of another node says the same time ahead, and nobody else was heard meanwhile:
/// then time has passed for all, as where all report seldom.
bool FusionClock::another_agrees(std::int32_t node_id, const Node& node, std::int64_t utime) const {
  const double shift = apart(node.offset, 0);
  const double ahead = apart(utime, *now_) + shift;
  if (!node.alone || ahead < 0.0 || ahead > params_.max_interval) return false;
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const auto& entry) {
    const Node& other = entry.second;
    if (entry.first == node_id || other.outliers == 0 || !other.alone) return false;
    const double theirs = apart(other.outlier, *now_) + apart(other.offset, 0);
    return std::abs(theirs - ahead) <= params_.tolerance;
  });
}

/// The stamps of others that said so too were right.
FusionClock::Reading FusionClock::pass_time(Node& node, std::int32_t node_id, std::int64_t utime) {
  const Reading reading = accept(node, node_id, utime);
  for (auto& [id, other] : nodes_) {
    const double shift = apart(other.offset, 0);
    if (other.outliers == 0 || std::abs(apart(other.outlier, utime) + shift) > params_.tolerance) continue;
    other.outliers = 0;
    learn(other, other.outlier + other.offset);
  }
  return reading;
}

void FusionClock::learn(Node& node, std::int64_t utime) const {
  if (node.newest) {
    const double step = apart(utime, *node.newest);
    if (step > 0.0) blend(node.interval, std::min(step, params_.max_interval));
  }
  blend(node.delay, std::max(0.0, apart(*now_, utime)));
  node.newest = std::max(node.newest.value_or(utime), utime);
}

FusionClock::Reading FusionClock::accept(Node& node, std::int32_t node_id, std::int64_t utime) {
  node.outliers = 0;
  now_ = std::max(*now_, utime);
  learn(node, utime);
  for (auto& [id, other] : nodes_) {
    if (id != node_id) other.alone = false;
  }
  return {utime, false};
}

FusionClock::Reading FusionClock::settle(Node& node, std::int32_t node_id, std::int64_t utime) {
  const double step = node.step;
  const auto begin_at = [&](std::int64_t time) {
    node.newest.reset();
    node.interval = std::max(0.0, step);
    return accept(node, node_id, time);
  };
  if (!node.alone) {
    node.offset = *now_ - utime;
    return begin_at(*now_);
  }
  const bool backwards = utime + node.offset < *now_;
  if (backwards) {
    nodes_.clear();
    now_ = utime;
    return {accept(nodes_[node_id], node_id, utime).utime, true};
  }
  now_ = utime + node.offset;
  return begin_at(*now_);
}

void FusionClock::judge(std::int32_t node_id, double for_delay) {
  const auto found = nodes_.find(node_id);
  if (found == nodes_.end() || found->second.delay <= params_.tolerance) return;
  Node& node = found->second;
  node.for_delay = std::clamp(node.for_delay + for_delay, -kJudgement, kJudgement);
  if (node.for_delay > -kJudgement) return;
  node.offset += core::microseconds(node.delay);
  node.newest.reset();
  node.delay = 0.0;
  node.for_delay = 0.0;
}

}  // namespace lookout::fusion
