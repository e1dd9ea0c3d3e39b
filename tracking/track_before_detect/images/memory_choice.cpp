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
constexpr float kRare = 1e-4f;         // probability at which the tails of two levels are compared
constexpr float kLeastShare = 1e-12f;  // below kRare: its logarithm is finite
constexpr float kQuarterPi = std::numbers::pi_v<float> / 4.0f;  // (mean / rms)^2 of a Rayleigh amplitude

/// ln of the ratio of two Rayleigh densities, of means `moved` and `still`.
float log_ratio(float ratio, float moved, float still) {
  const float square = std::min(ratio, kMostRatio) * std::min(ratio, kMostRatio);
  return 2.0f * std::log(still / moved) +
         kQuarterPi * square * (1.0f / (still * still) - 1.0f / (moved * moved));
}

/// A Rayleigh amplitude of level m reaches x with probability exp(-pi / 4 (x / m)^2); one that has this level
/// with a share alone is as rare as kRare at so many times the x. 0 of a share that is rarer.
float weight_of(float share) {
  return std::sqrt(std::max(0.0f, 1.0f - std::log(share + kLeastShare) / std::log(kRare)));
}

float share_of(float evidence) {
  return 1.0f / (1.0f + std::exp(-evidence - kPrior));
}

}  // namespace

void MemoryChoice::begin(int columns, int rows) {
  columns_ = columns;
  across_ = static_cast<std::size_t>((columns + kBlockColumns - 1) / kBlockColumns);
  const std::size_t blocks = across_ * static_cast<std::size_t>((rows + kBlockRows - 1) / kBlockRows);
  evidence_.assign(blocks, 0.0f);
  for (auto* values : {&share_, &moved_weight_, &still_weight_}) values->resize(blocks);
  for (std::size_t block = 0; block < blocks; ++block) weigh(block);
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
    weigh(block);
  }
}

/// The level of the likelier memory counts wholly.
void MemoryChoice::weigh(std::size_t block) {
  share_[block] = share_of(evidence_[block]);
  const float moved = weight_of(share_[block]), still = weight_of(1.0f - share_[block]);
  moved_weight_[block] = moved / std::max(moved, still);
  still_weight_[block] = still / std::max(moved, still);
}

}  // namespace lookout::tracking
