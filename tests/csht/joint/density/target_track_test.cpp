#include "csht/joint/density/target_track.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

TEST(RecentEvidence, SumsTheLatest) {
  RecentEvidence recent;
  for (int k = 1; k <= 100; ++k) recent.add(k, 1.0);
  EXPECT_EQ(recent.size(), RecentEvidence::kCapacity);
  EXPECT_DOUBLE_EQ(recent.sum(3), 100.0 + 99.0 + 98.0);
  EXPECT_DOUBLE_EQ(recent.expected(3), 3.0);
  recent.clear();
  EXPECT_EQ(recent.size(), 0);
}

TEST(LogOdds, OfAProbabilityAndBack) {
  EXPECT_DOUBLE_EQ(probability(0.0), 0.5);
  EXPECT_NEAR(probability(log_odds(0.9)), 0.9, 1e-12);
}

}  // namespace
}  // namespace lookout::csht
