#include "csht/likelihood/clutter/dense_returns.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

constexpr double kShare = 0.05;

DenseReturns taught(int scans, int returns, int dense, double rate) {
  DenseReturns learnt({}, kShare);
  for (int k = 0; k < scans; ++k) {
    learnt.begin_scan();
    for (int j = 0; j < returns; ++j) learnt.take(1.0, j < dense ? 1.0 : 0.0, rate);
  }
  return learnt;
}

TEST(DenseReturns, BeforeAnyReturnItBelievesWhatItWasGiven) {
  const DenseReturns learnt({}, kShare);
  EXPECT_DOUBLE_EQ(learnt.share(), kShare);
  EXPECT_DOUBLE_EQ(learnt.mean_rate(), 1.0);
}

// Six returns of ten, each of a place that returns forty times as much.
TEST(DenseReturns, LearnsShareAndRate) {
  const DenseReturns learnt = taught(200, 10, 6, 40.0);
  EXPECT_NEAR(learnt.share(), 0.6, 0.01);
  EXPECT_NEAR(learnt.mean_rate(), 40.0, 0.5);
}

TEST(DenseReturns, ReturnsOfTargetsTeachNothing) {
  DenseReturns learnt({}, kShare);
  for (int k = 0; k < 50; ++k) learnt.take(0.0, 1.0, 100.0);
  EXPECT_DOUBLE_EQ(learnt.share(), kShare);
  EXPECT_DOUBLE_EQ(learnt.mean_rate(), 1.0);
}

// 40 scans of memory: after 200 empty ones less than one per cent is left of what came before.
TEST(DenseReturns, ForgetsWhatIsLongAgo) {
  DenseReturns learnt = taught(200, 10, 6, 40.0);
  for (int k = 0; k < 200; ++k) {
    learnt.begin_scan();
    for (int j = 0; j < 10; ++j) learnt.take(1.0, 0.0, 1.0);
  }
  EXPECT_LT(learnt.share(), 0.01);
}

TEST(DenseReturns, NoPlaceReturnsLessThanTheBackground) {
  EXPECT_DOUBLE_EQ(taught(200, 10, 6, 0.2).mean_rate(), 1.0);
}

}  // namespace
}  // namespace lookout::csht
