#include "csht/likelihood/clutter/typical_rate.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr int kAcross = 16, kAlong = 8;  // Blocks of the fan, as far as it has beams for them.
constexpr double kFewEmpty = 0.2;  // Share of empty blocks from which on counts are too small for a median.
constexpr double kClearlyMore = 1.3;  // Times the typical rate that is no chance any more.

}  // namespace

void TypicalRate::begin(int num_beams) {
  across_ = std::min(num_beams, kAcross);
  blocks_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(kAlong), 0.0F);
}

void TypicalRate::take(double across, double along, float weight) {
  if (across < 0.0 || across >= 1.0 || along < 0.0 || along >= 1.0) return;
  const int block = static_cast<int>(across * across_) * kAlong + static_cast<int>(along * kAlong);
  blocks_[static_cast<std::size_t>(block)] += weight;
}

void TypicalRate::end(double scans) {
  const auto blocks = static_cast<double>(blocks_.size());
  const auto empty = static_cast<double>(std::count(blocks_.begin(), blocks_.end(), 0.0F)) / blocks;
  const auto middle = blocks_.begin() + static_cast<std::ptrdiff_t>(blocks_.size() / 2);
  std::nth_element(blocks_.begin(), middle, blocks_.end());
  const double typical = empty > kFewEmpty ? -std::log(empty) : static_cast<double>(*middle);
  rate_ = typical * blocks / scans;
}

double TypicalRate::at_most(double rate) const {
  return rate_ > 0.0 ? std::min(rate, kClearlyMore * rate_) : rate;
}

}  // namespace lookout::csht
