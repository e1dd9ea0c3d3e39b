#include "csht/likelihood/empty_scans.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

TEST(EmptyScans, AScanWithReturnsWasHeard) {
  EmptyScans scans;
  EXPECT_EQ(scans.take(9), 1.0);
}

TEST(EmptyScans, OfASonarThatNeverReturnedAnythingNothingIsLost) {
  EmptyScans scans;
  for (int k = 0; k < 50; ++k) EXPECT_EQ(scans.take(0), 1.0);
}

// Nine returns a scan: an empty one comes about by e^-9 = .0001 unless it was lost.
TEST(EmptyScans, AnEmptyScanAmongFullOnesWasLost) {
  EmptyScans scans;
  for (int k = 0; k < 50; ++k) scans.take(9);
  EXPECT_LT(scans.take(0), 0.1);
}

// One return in two scans: e^-.5 = .6 of them are empty, and nothing says that any was lost.
TEST(EmptyScans, OfFewReturnsAnEmptyScanIsNoWonder) {
  EmptyScans scans;
  double listened = 0.0;
  for (int k = 0; k < 400; ++k) listened = scans.take(k % 5 == 0 ? 2 : (k % 5 == 1 ? 1 : 0));
  EXPECT_GT(listened, 0.9);
  EXPECT_LT(scans.lost_share(), 0.05);
}

TEST(EmptyScans, LearnsHowManyAreLost) {
  EmptyScans scans;
  for (int k = 0; k < 500; ++k) scans.take(k % 5 == 0 ? 0 : 9);
  EXPECT_NEAR(scans.lost_share(), 0.2, 0.02);
}

}  // namespace
}  // namespace lookout::csht
