#include "tracking/track_before_detect/images/level_memory.hpp"

#include <algorithm>

namespace lookout::tracking {

void LevelMemory::begin(std::size_t cells) {
  for (auto* values : {&mean_, &count_, &swift_, &kept_}) values->assign(cells, 0.0f);
}

void LevelMemory::learn(std::size_t cell, float ratio, const MemoryRates& rates) {
  glance(cell, ratio, rates);
  kept_[cell] = 0.0f;
  count_[cell] = std::min(count_[cell] + 1.0f, rates.most_pings);
  mean_[cell] += (ratio - mean_[cell]) / count_[cell];
}

void LevelMemory::keep(std::size_t cell, float ratio, const MemoryRates& rates) {
  const float kept = kept_[cell] + 1.0f;
  if (kept > rates.most_kept)
    learn(cell, ratio, rates);
  else
    glance(cell, ratio, rates);
  kept_[cell] = kept;
}

/// The swift memory takes in everything.
void LevelMemory::glance(std::size_t cell, float ratio, const MemoryRates& rates) {
  swift_[cell] += rates.swift_share * (ratio - swift_[cell]);
}

void LevelMemory::stand(std::size_t cell, float ratio, const MemoryRates& rates) {
  glance(cell, ratio, rates);
  kept_[cell] = 0.0f;
  mean_[cell] = swift_[cell];
  count_[cell] = rates.most_pings;
}

void LevelMemory::move(const std::vector<std::uint32_t>& from) {
  for (auto* values : {&mean_, &count_, &swift_, &kept_}) {
    moved_.resize(values->size());
    for (std::size_t cell = 0; cell < from.size(); ++cell)
      moved_[cell] = from[cell] == kNew ? 0.0f : (*values)[from[cell]];
    values->swap(moved_);
  }
}

}  // namespace lookout::tracking
