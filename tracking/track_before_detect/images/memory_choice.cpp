#include "tracking/track_before_detect/images/memory_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr float kFade = 0.9f;          // of the evidence, a ping
constexpr float kMost = 30.0f;         // evidence beyond this says no more
constexpr float kCellsOfGrain = 4.0f;  // neighbouring cells that speak as one, their speckle being common
constexpr float kPrior = 2.0f;         // ln of how much more is expected to stand on the earth
constexpr float kMostRatio = 10.0f;    // a brighter cell, an echo, says no more
constexpr float kQuarterPi = std::numbers::pi_v<float> / 4.0f;  // (mean / rms)^2 of a Rayleigh amplitude

/// ln of the ratio of two Rayleigh densities, of means `moved` and `still`.
float log_ratio(float ratio, float moved, float still) {
  const float square = std::min(ratio, kMostRatio) * std::min(ratio, kMostRatio);
  return 2.0f * std::log(still / moved) +
         kQuarterPi * square * (1.0f / (still * still) - 1.0f / (moved * moved));
}

float share_of(float evidence) {
  return 1.0f / (1.0f + std::exp(-evidence - kPrior));
}

}  // namespace

void MemoryChoice::begin(int columns, int rows) {
  columns_ = columns;
  across_ = static_cast<std::size_t>((columns + kBlock - 1) / kBlock);
  const std::size_t blocks = across_ * static_cast<std::size_t>((rows + kBlock - 1) / kBlock);
  evidence_.assign(blocks, 0.0f);
  share_.assign(blocks, share_of(0.0f));
}

void MemoryChoice::add(int row, const float* ratio, const float* moved, const float* still) {
  for (int column = 0; column < columns_; ++column) {
    if (moved[column] == still[column]) continue;
    evidence_[block_of(column, row)] +=
        log_ratio(ratio[column], moved[column], still[column]) / kCellsOfGrain;
  }
}

void MemoryChoice::settle() {
  for (std::size_t block = 0; block < evidence_.size(); ++block) {
    evidence_[block] = std::clamp(kFade * evidence_[block], -kMost, kMost);
    share_[block] = share_of(evidence_[block]);
  }
}

}  // namespace lookout::tracking
