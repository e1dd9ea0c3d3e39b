#include "tracking/initiation/lines/sparse_accumulator.hpp"

#include <algorithm>
#include <cassert>

namespace lookout::tracking {
namespace {

constexpr std::size_t kFirstSlots = 1024;

/// Multiplicative hashing (Knuth), which spreads neighbouring cells.
std::size_t hashed(std::int64_t key) {
  return static_cast<std::size_t>((static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15ULL) >> 20);
}

}  // namespace

SparseAccumulator::SparseAccumulator() : slots_(kFirstSlots, -1) {}

std::size_t SparseAccumulator::slot_of(std::int64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hashed(key) & mask;
  while (slots_[slot] >= 0 && entries_[static_cast<std::size_t>(slots_[slot])].key != key)
    slot = (slot + 1) & mask;
  return slot;
}

SparseAccumulator::Entry& SparseAccumulator::entry(std::int64_t key) {
  assert(key >= 0);
  if (2 * (entries_.size() + 1) > slots_.size()) grow();
  const std::size_t slot = slot_of(key);
  if (slots_[slot] < 0) {
    slots_[slot] = static_cast<std::int32_t>(entries_.size());
    entries_.push_back({key});
  }
  return entries_[static_cast<std::size_t>(slots_[slot])];
}

void SparseAccumulator::raise(std::int64_t key, int step, double vote) {
  Entry& cell = entry(key);
  if (cell.step != step) {
    cell.value += cell.step_value;
    cell.step_value = 0.0;
    cell.step = step;
  }
  cell.step_value = std::max(cell.step_value, vote);
}

double SparseAccumulator::value(std::int64_t key) const {
  const std::int32_t found = slots_[slot_of(key)];
  return found < 0 ? 0.0 : entries_[static_cast<std::size_t>(found)].total();
}

void SparseAccumulator::grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (std::size_t i = 0; i < entries_.size(); ++i)
    slots_[slot_of(entries_[i].key)] = static_cast<std::int32_t>(i);
}

void SparseAccumulator::clear() {
  // Few entries in a table grown large: free their own slots, newest first so that each is still found.
  if (entries_.size() * 8 < slots_.size()) {
    for (; !entries_.empty(); entries_.pop_back()) slots_[slot_of(entries_.back().key)] = -1;
  } else {
    std::fill(slots_.begin(), slots_.end(), -1);
    entries_.clear();
  }
}

}  // namespace lookout::tracking
