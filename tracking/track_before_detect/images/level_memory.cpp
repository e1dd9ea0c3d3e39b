#include "tracking/track_before_detect/images/level_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lookout::tracking {
namespace {

constexpr std::uint32_t kNew = 0xffffffffu;  // a cell that was not in the image before

}  // namespace

void LevelMemory::begin(std::size_t cells) {
  for (auto* values : {&mean_, &count_, &swift_, &kept_, &held_}) values->assign(cells, 0.0f);
  drift_.assign(cells, Eigen::Vector2f::Zero());
}

void LevelMemory::learn(std::size_t cell, float ratio, const MemoryRates& rates) {
  glance(cell, ratio, rates);
  kept_[cell] = std::max(0.0f, kept_[cell] - 1.0f);
  take_in(cell, ratio, 1.0f, rates);
  drift_[cell] -= drift_[cell] / count_[cell];
}

void LevelMemory::keep(std::size_t cell, float ratio, float most_kept, const MemoryRates& rates) {
  glance(cell, ratio, rates);
  if (kept_[cell] > most_kept) {
    take_in(cell, ratio, 1.0f, rates);
    return;
  }
  kept_[cell] += 1.0f;
  held_[cell] += (ratio - held_[cell]) / kept_[cell];
  if (kept_[cell] > most_kept) take_in(cell, held_[cell], kept_[cell], rates);
}

/// Learns `ratio` as the mean of so many pings.
void LevelMemory::take_in(std::size_t cell, float ratio, float pings, const MemoryRates& rates) {
  count_[cell] = std::min(count_[cell] + pings, rates.most_pings);
  mean_[cell] += (ratio - mean_[cell]) * std::min(1.0f, pings / count_[cell]);
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

/// The cell next to a place whose memory lies nearest to it; kNew outside the image.
std::uint32_t LevelMemory::source_of(const Eigen::Vector2f& from, int columns, int rows) const {
  const auto x = static_cast<int>(std::lround(from.x())), y = static_cast<int>(std::lround(from.y()));
  if (x < 0 || x >= columns || y < 0 || y >= rows) return kNew;
  std::uint32_t best = kNew;
  float least = std::numeric_limits<float>::max();
  for (int row = std::max(0, y - 1); row <= std::min(rows - 1, y + 1); ++row)
    for (int column = std::max(0, x - 1); column <= std::min(columns - 1, x + 1); ++column) {
      const auto cell = static_cast<std::uint32_t>(row * columns + column);
      const Eigen::Vector2f place(static_cast<float>(column), static_cast<float>(row));
      const float off = (place + drift_[cell] - from).squaredNorm();
      if (off < least) least = off, best = cell;
    }
  return best;
}

void LevelMemory::move(const std::vector<Eigen::Vector2f>& from, int columns) {
  const int rows = static_cast<int>(from.size()) / columns;
  const auto width = static_cast<std::uint32_t>(columns);
  source_.resize(from.size());
  moved_drift_.assign(from.size(), Eigen::Vector2f::Zero());
  for (std::size_t cell = 0; cell < from.size(); ++cell) {
    const std::uint32_t source = source_[cell] = source_of(from[cell], columns, rows);
    if (source == kNew) continue;
    const std::uint32_t row = source / width, column = source % width;
    const Eigen::Vector2f place(static_cast<float>(column), static_cast<float>(row));
    moved_drift_[cell] = place + drift_[source] - from[cell];
  }
  drift_.swap(moved_drift_);
  for (auto* values : {&mean_, &count_, &swift_, &kept_, &held_}) {
    moved_.resize(values->size());
    for (std::size_t cell = 0; cell < from.size(); ++cell)
      moved_[cell] = source_[cell] == kNew ? 0.0f : (*values)[source_[cell]];
    values->swap(moved_);
  }
}

}  // namespace lookout::tracking
