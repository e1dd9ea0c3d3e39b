#include "tools/experiments/harness/quantiles.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

namespace lookout::tools {
namespace {

// 0 to 200 in any order: the middle one, and the one that two in 201 exceed.
TEST(Quantiles, AreThoseOfTheSortedValues) {
  std::vector<double> values(201);
  std::iota(values.begin(), values.end(), 0.0);
  std::swap(values.front(), values.back());
  EXPECT_EQ(median(values), 100.0);
  EXPECT_EQ(quantile(values, 0.99), 198.0);
  EXPECT_EQ(quantile(values, 0.0), 0.0);
  EXPECT_EQ(quantile(values, 1.0), 200.0);
}

TEST(Quantiles, OfFewValuesAreOneOfThem) {
  EXPECT_EQ(median({7.0}), 7.0);
  EXPECT_EQ(quantile({7.0}, 0.99), 7.0);
  EXPECT_EQ(median({3.0, 5.0}), 5.0);
}

}  // namespace
}  // namespace lookout::tools
