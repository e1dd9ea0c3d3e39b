#include "tracking/track_before_detect/images/wide_level.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

constexpr double kLeastSpread = 3.0;  // beams: of two at half of their power, as beams are formed
constexpr int kWindowOfSpreads = 4;   // of which an echo is a share below what kQuartile leaves out
constexpr int kShareOfTheFan = 8;     // a window is an eighth of it, where that is more
constexpr float kQuartile = 0.75f;    // of values in order
constexpr int kMostValues = 33;       // that a quartile is taken of
constexpr int kSwiftlyLearnt = 12;    // pings in which a memory changes much from one to the next

}  // namespace

void WideLevel::begin(int bins, int beams) {
  bins_ = bins;
  beams_ = beams;
  widen(kLeastSpread);
  pings_ = 0;
  level_.assign(index(0, beams + kStep - 1), 1.0f);
}

void WideLevel::widen(double beams) {
  const int cells = 1 + static_cast<int>(std::lround(std::max(kLeastSpread, beams)));
  window_ = std::min(beams_, std::max(kWindowOfSpreads * cells + 1, beams_ / kShareOfTheFan));
}

void WideLevel::update(const LevelMemory& memory, float prior) {
  const int step = pings_ < kSwiftlyLearnt ? 1 : kStep;
  for (int beam = 0; beam < beams_; beam += kStep)
    for (int bin = pings_ % step; bin < bins_; bin += step)
      level_[index(bin, beam)] = quartile_around(memory, prior, bin, std::min(beams_ - 1, beam + kStep / 2));
  ++pings_;
}

/// Of a window about a beam, which is as wide at the borders of the fan.
float WideLevel::quartile_around(const LevelMemory& memory, float prior, int bin, int beam) {
  const int first = std::clamp(beam - window_ / 2, 0, beams_ - window_);
  const int stride = std::max(1, window_ / kMostValues);
  values_.clear();
  for (int near = first; near < first + window_; near += stride) {
    const auto cell = static_cast<std::size_t>(near) * static_cast<std::size_t>(bins_);
    values_.push_back(memory.level(cell + static_cast<std::size_t>(bin), prior));
  }
  const auto quartile =
      values_.begin() + static_cast<std::ptrdiff_t>(static_cast<float>(values_.size()) * kQuartile);
  std::nth_element(values_.begin(), quartile, values_.end());
  return *quartile;
}

}  // namespace lookout::tracking
