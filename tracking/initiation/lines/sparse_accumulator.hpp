#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lookout::tracking {

/// Votes for the few cells that are hit, keyed by a cell number >= 0: open addressing, in the order of first
/// votes. A cleared accumulator keeps its memory, so that a warm one allocates nothing.
class SparseAccumulator {
 public:
  /// A cell and its votes.
  struct Entry {
    std::int64_t key = 0;     ///< Number of the cell.
    double value = 0.0;       ///< Sum of the votes; of finished steps alone where `raise` is used.
    double step_value = 0.0;  ///< Largest vote of the step at hand.
    int step = -1;            ///< The step that `step_value` belongs to.
    /// Sum of the votes, those of the step at hand included.
    double total() const { return value + step_value; }
  };

  SparseAccumulator();

  void add(std::int64_t key, double vote) { entry(key).value += vote; }  ///< Adds a vote to a cell.
  /// Lets a step contribute its largest vote alone: one target gives one pair of plots a step.
  void raise(std::int64_t key, int step, double vote);

  double value(std::int64_t key) const;  ///< Total of a cell, 0 where nothing voted.
  /// The cells that hold votes, in the order of their first; valid until the next vote.
  std::span<const Entry> entries() const { return entries_; }
  void clear();  ///< Forgets all votes and keeps the memory.

 private:
  Entry& entry(std::int64_t key);
  std::size_t slot_of(std::int64_t key) const;
  void grow();

  std::vector<Entry> entries_;
  std::vector<std::int32_t> slots_;  ///< Index into `entries_`, -1 where free; size a power of two.
};

}  // namespace lookout::tracking
