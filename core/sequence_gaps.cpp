#include "core/sequence_gaps.hpp"

#include <algorithm>
#include <utility>

namespace lookout::core {
namespace {

/// How far after the numbers before a mistake the next may go on: at once, or after the mistake's own number.
constexpr std::uint64_t kGoesOn = 2;
/// A leap of no more is one of numbers that come in another order, and no damaged counter.
constexpr std::uint64_t kReordered = 64;

/// A number that is farther behind does not come late: the sender goes on from there.
constexpr std::uint64_t kLatest = 256;

/// Unsigned: the difference of two numbers from outside may not fit a signed one.
std::uint64_t distance(std::int64_t from, std::int64_t to) {
  return static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
}

}  // namespace

SequenceGaps::Step SequenceGaps::add(std::int64_t sequence) {
  if (!last_) {
    last_ = sequence;
    before_.reset();
    return Step::in_order;
  }
  if (sequence == *last_) return Step::repeated;
  const auto before = std::exchange(before_, std::nullopt);
  if (before && was_mistake(*before, *last_, sequence)) {
    counts_ = before->counts;
    missing_ = before->missing;
    last_ = sequence;
    return Step::in_order;
  }
  const bool may_be_late = sequence < *last_ && distance(sequence, *last_) <= kLatest;
  if (may_be_late && is_found(sequence)) return Step::in_order;
  const std::int64_t last = *std::exchange(last_, sequence);
  if (sequence > last && distance(last, sequence) == 1) return Step::in_order;
  before_ = Before{last, counts_, missing_};
  return surprise(last, sequence);
}

/// Whether the number before this one fits neither those before it nor this one.
bool SequenceGaps::was_mistake(const Before& before, std::int64_t last, std::int64_t sequence) const {
  const bool goes_on = sequence > before.last && distance(before.last, sequence) <= kGoesOn;
  return goes_on && (last < before.last || distance(before.last, last) > kReordered);
}

SequenceGaps::Step SequenceGaps::surprise(std::int64_t last, std::int64_t sequence) {
  if (sequence < last || distance(last, sequence) > static_cast<std::uint64_t>(kLargestLoss)) {
    ++counts_.restarts;
    missing_.clear();
    return Step::restart;
  }
  const std::int64_t lost = counts_.lost;
  counts_.lost += sequence - last - 1;
  if (missing_.size() >= kMostGaps) missing_.erase(missing_.begin());
  missing_.push_back({last + 1, sequence});
  for (std::size_t i = 0; i < std::min(num_refused_, kRemembered); ++i)
    if (last < refused_[i] && refused_[i] < sequence) is_found(refused_[i]);
  return counts_.lost > lost ? Step::gap : Step::in_order;
}

void SequenceGaps::refused(std::int64_t sequence) {
  if (!is_found(sequence)) refused_[num_refused_++ % kRemembered] = sequence;
}

/// Whether a number was missing; it is so no longer.
bool SequenceGaps::is_found(std::int64_t sequence) {
  const auto gap = std::find_if(missing_.begin(), missing_.end(), [=](const Missing& missing) {
    return missing.first <= sequence && sequence < missing.end;
  });
  if (gap == missing_.end()) return false;
  const Missing rest{sequence + 1, gap->end};
  gap->end = sequence;
  const auto behind = gap->first == gap->end ? missing_.erase(gap) : gap + 1;
  if (rest.first < rest.end) missing_.insert(behind, rest);
  --counts_.lost;
  return true;
}

void SequenceGaps::forget() {
  last_.reset();
  missing_.clear();
}

}  // namespace lookout::core
