#pragma once

#include <cstdint>
#include <optional>

namespace lookout::core {

/// Counts what is missing from a numbered stream. Going backwards, or farther ahead than any burst of loss,
/// is a restart of the sender and not a loss; the same number again is neither.
class SequenceGaps {
 public:
  static constexpr std::int64_t kLargestLoss =
      100'000;  ///< Numbers skipped at once that still count as lost.

  /// How a number follows the one before: the next, the same, ahead with a loss, or begun anew.
  enum class Step { in_order, repeated, gap, restart };

  /// Takes the next sequence number and says how it follows the one before; the first is in order.
  Step add(std::int64_t sequence) {
    const std::optional<std::int64_t> last = last_;
    last_ = sequence;
    if (!last) return Step::in_order;
    if (sequence == *last) return Step::repeated;
    // Unsigned: the difference of two numbers from outside may not fit a signed one.
    const auto ahead = static_cast<std::uint64_t>(sequence) - static_cast<std::uint64_t>(*last);
    if (sequence < *last || ahead > static_cast<std::uint64_t>(kLargestLoss)) {
      ++restarts_;
      return Step::restart;
    }
    lost_ += static_cast<std::int64_t>(ahead) - 1;
    return ahead == 1 ? Step::in_order : Step::gap;
  }

  std::int64_t lost() const { return lost_; }          ///< Numbers that were skipped.
  std::int64_t restarts() const { return restarts_; }  ///< Times that the sender began again.
  void forget() { last_.reset(); }                     ///< The next number is the first; the counts stay.

 private:
  std::optional<std::int64_t> last_;
  std::int64_t lost_ = 0;
  std::int64_t restarts_ = 0;
};

}  // namespace lookout::core
