#include "core/sequence_gaps.hpp"

#include <algorithm>
#include <utility>

namespace lookout::core {
namespace {

/// How far after the numbers before a mistake the next may go on: at once, or after the mistake's own number.
constexpr std::uint64_t kGoesOn = 2;

/// Unsigned: the difference of two numbers from outside may not fit a signed one.
std::uint64_t distance(std::int64_t from, std::int64_t to) {
  return static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
}

}  // namespace

SequenceGaps::Step SequenceGaps::add(std::int64_t sequence) {
  const std::optional<std::int64_t> last = std::exchange(last_, sequence);
  if (!last) {
    before_.reset();
    return Step::in_order;
  }
  if (sequence == *last) return Step::repeated;
  const auto before = std::exchange(before_, std::nullopt);
  if (before && sequence > before->last && distance(before->last, sequence) <= kGoesOn) {
    counts_ = before->counts;
    gap_end_ = gap_first_;
    return Step::in_order;
  }
  if (sequence > *last && distance(*last, sequence) == 1) return Step::in_order;
  before_ = Before{*last, counts_};
  return surprise(*last, sequence);
}

SequenceGaps::Step SequenceGaps::surprise(std::int64_t last, std::int64_t sequence) {
  if (sequence < last || distance(last, sequence) > static_cast<std::uint64_t>(kLargestLoss)) {
    ++counts_.restarts;
    return Step::restart;
  }
  gap_first_ = last + 1;
  gap_end_ = sequence;
  const std::int64_t missing = gap_end_ - gap_first_ - refused_between(gap_first_, gap_end_);
  counts_.lost += missing;
  return missing > 0 ? Step::gap : Step::in_order;
}

void SequenceGaps::refused(std::int64_t sequence) {
  if (gap_first_ <= sequence && sequence < gap_end_ && counts_.lost > 0)
    --counts_.lost;
  else
    refused_[num_refused_++ % kRemembered] = sequence;
}

std::int64_t SequenceGaps::refused_between(std::int64_t first, std::int64_t end) const {
  const auto stop = refused_.begin() + static_cast<std::ptrdiff_t>(std::min(num_refused_, kRemembered));
  const auto missing =
      std::count_if(refused_.begin(), stop, [=](std::int64_t n) { return first <= n && n < end; });
  return std::min<std::int64_t>(missing, end - first);
}

}  // namespace lookout::core
