#include "tracking/intake/reorder_hold.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

TEST(ReorderHold, HoldsNothingWhileAllComesInOrder) {
  EXPECT_EQ(ReorderHold(kSecond).at(100 * kSecond), 0);
}

TEST(ReorderHold, HoldsAsLongAsWasTooShortForAMinute) {
  ReorderHold hold(kSecond);
  hold.note(kSecond / 2, 10 * kSecond, true);
  EXPECT_EQ(hold.at(11 * kSecond), kSecond / 2);
  EXPECT_EQ(hold.at(70 * kSecond), kSecond / 2);
  EXPECT_EQ(hold.at(71 * kSecond), 0);
}

TEST(ReorderHold, IsNotMovedByWhatCameInTimeOrFarTooLate) {
  ReorderHold hold(kSecond);
  hold.note(kSecond / 2, 0, false);
  hold.note(2 * kSecond, 0, true);
  EXPECT_EQ(hold.at(0), 0);
}

}  // namespace
}  // namespace lookout::tracking
