#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lookout::core {

/// Counts what is missing from a numbered stream. Going backwards, or farther ahead than any burst of loss,
/// is a restart of the sender and not a loss; the same number again is neither. A number that was missing and
/// comes late, taken or refused, is no longer lost. One number that fits neither those before nor those after
/// it (a damaged counter, a late double) is taken back by the next.
class SequenceGaps {
 public:
  static constexpr std::int64_t kLargestLoss =
      100'000;  ///< Numbers skipped at once that still count as lost.

  /// What a number is to those before it.
  enum class Step { in_order, repeated, gap, restart };

  /// The number of the next message that was taken.
  Step add(std::int64_t sequence);

  /// The number of a message that came but was refused for another reason: it is not lost.
  void refused(std::int64_t sequence);

  std::int64_t lost() const { return counts_.lost; }          ///< Numbers that were skipped.
  std::int64_t restarts() const { return counts_.restarts; }  ///< Times that the sender began again.
  void forget();  ///< The next number is the first; the counts stay.

 private:
  struct Counts {
    std::int64_t lost = 0;
    std::int64_t restarts = 0;
  };
  /// Numbers that never came: [first, end).
  struct Missing {
    std::int64_t first = 0, end = 0;
  };
  /// What held before a step that may have been a mistake.
  struct Before {
    std::int64_t last = 0;
    Counts counts;
    std::vector<Missing> missing;
  };

  Step surprise(std::int64_t last, std::int64_t sequence);
  bool was_mistake(const Before& before, std::int64_t last, std::int64_t sequence) const;
  bool is_found(std::int64_t sequence);

  static constexpr std::size_t kRemembered = 256;  ///< Refused numbers that a gap is compared with.
  static constexpr std::size_t kMostGaps = 64;     ///< Gaps whose numbers may still come.
  std::optional<std::int64_t> last_;
  std::optional<Before> before_;
  Counts counts_;
  std::vector<Missing> missing_;  ///< The newest last.
  std::array<std::int64_t, kRemembered> refused_{};
  std::size_t num_refused_ = 0;
};

}  // namespace lookout::core
