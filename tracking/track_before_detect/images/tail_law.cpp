#include "tracking/track_before_detect/images/tail_law.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

// The slope comes from two quantiles, so that a few blocks with targets in them do not change it: the upper
// one leaves out at least eight blocks.
constexpr double kBlocksLeftOut = 8.0;
constexpr double kLeastShare = 0.005;
constexpr double kMostShare = 0.1;
constexpr double kShareRatio = 10.0;  // of the lower quantile's upper share to the upper one's
constexpr double kMostTail = 0.4;     // upper share at which a tail may begin
constexpr int kMemory = 10;           // frames that place and slope are averaged over
constexpr double kLeastSlope = 1e-3;  // of a frame without any noise

}  // namespace

void TailLaw::learn(std::span<const double> ascending) {
  ascending_ = ascending;
  if (ascending.empty()) return;
  const double upper =
      std::clamp(kBlocksLeftOut / static_cast<double>(ascending.size()), kLeastShare, kMostShare);
  share_ = std::min(kMostTail, kShareRatio * upper);
  const double start = quantile(share_);
  const double slope = std::max(kLeastSlope, (quantile(upper) - start) / std::log(share_ / upper));
  frames_ = std::min(frames_ + 1, kMemory);
  start_ += (start - start_) / frames_;
  slope_ += (slope - slope_) / frames_;
}

double TailLaw::log_probability(double value) const {
  if (ascending_.empty()) return 0.0;
  if (value <= start_) return log_rank(value);
  return std::log(share_) - (value - start_) / slope_;
}

double TailLaw::value_of(double probability) const {
  if (ascending_.empty()) return 0.0;
  if (probability >= share_) return quantile(probability);
  return start_ + slope_ * std::log(share_ / probability);
}

double TailLaw::quantile(double upper_share) const {
  const auto size = static_cast<double>(ascending_.size());
  const auto at = static_cast<std::size_t>((1.0 - upper_share) * size);
  return ascending_[std::min(at, ascending_.size() - 1)];
}

double TailLaw::log_rank(double value) const {
  const auto reaching = ascending_.end() - std::lower_bound(ascending_.begin(), ascending_.end(), value);
  return std::log((static_cast<double>(reaching) + 1.0) / (static_cast<double>(ascending_.size()) + 1.0));
}

}  // namespace lookout::tracking
