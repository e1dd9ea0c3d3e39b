#include "lcmtypes/latency_window.hpp"

#include <gtest/gtest.h>

namespace lookout::lcmtypes {
namespace {

TEST(LatencyWindow, GivesPercentilesByRank) {
  LatencyWindow window;
  EXPECT_EQ(window.percentile(0.5), 0.0);
  for (int i = 1; i <= 100; ++i) window.add(i);
  EXPECT_EQ(window.percentile(0.50), 50.0);
  EXPECT_EQ(window.percentile(0.99), 99.0);
  EXPECT_EQ(window.percentile(0.0), 1.0);
  EXPECT_EQ(window.percentile(1.0), 100.0);
}

TEST(LatencyWindow, KeepsTheNewestThousand) {
  LatencyWindow window;
  for (int i = 1; i <= 3000; ++i) window.add(i);
  EXPECT_EQ(window.percentile(0.0), 2001.0);
  EXPECT_EQ(window.percentile(1.0), 3000.0);
}

}  // namespace
}  // namespace lookout::lcmtypes
