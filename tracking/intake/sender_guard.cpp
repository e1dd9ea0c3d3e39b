#include "tracking/intake/sender_guard.hpp"

#include <algorithm>
#include <utility>

namespace lookout::tracking {
namespace {

/// Unsigned: the difference of two numbers from outside may not fit a signed one.
bool goes_on(std::optional<std::int64_t> line, std::int64_t sequence) {
  if (!line) return false;
  const auto [low, high] = std::minmax(*line, sequence);
  return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) <= SenderGuard::kNear;
}

}  // namespace

bool SenderGuard::is_foreign(std::int64_t sequence) {
  if (!own_ || goes_on(own_, sequence)) {
    if (std::exchange(others_, 0) > 0) ++turns_;
    own_ = std::max(own_.value_or(sequence), sequence);
    return false;
  }
  if (!goes_on(other_, sequence)) turns_ = 0;
  other_ = sequence;
  if (++others_ < kGone) return turns_ >= kShown;
  *this = SenderGuard();
  own_ = sequence;
  return false;
}

}  // namespace lookout::tracking
