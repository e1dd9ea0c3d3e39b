#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::core {
namespace {

TEST(Random, SameSeedStreamAndIndexRepeat) {
  Random a(7, RandomStream::simulator, 3);
  Random b(7, RandomStream::simulator, 3);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a(), b());
}

TEST(Random, StreamsAndIndicesDiffer) {
  Random a(7, RandomStream::simulator, 3);
  Random b(7, RandomStream::tracker, 3);
  Random c(7, RandomStream::simulator, 4);
  const auto first = a();
  EXPECT_NE(first, b());
  EXPECT_NE(first, c());
}

TEST(Random, ReseedForgetsAnEarlierGaussian) {
  Random a(1, RandomStream::tracker, 0);
  Random b(1, RandomStream::tracker, 0);
  a.gaussian();  // the polar method keeps a second value; reseeding must drop it
  a.reseed(5, RandomStream::tracker, 2);
  b.reseed(5, RandomStream::tracker, 2);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(a.gaussian(), b.gaussian());
}

TEST(Random, GaussianHasZeroMeanAndUnitVariance) {
  Random random(1);
  constexpr int kDraws = 100000;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.gaussian();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 / std::sqrt(kDraws));  // five standard errors
  EXPECT_NEAR(squares / kDraws, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
}

TEST(Random, UniformStaysInsideItsHalfOpenInterval) {
  Random random(2);
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(2.0, 3.0);
    ASSERT_GE(x, 2.0);
    ASSERT_LT(x, 3.0);
  }
}

TEST(Random, PoissonHasItsMean) {
  Random random(3);
  constexpr int kDraws = 20000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) sum += random.poisson(4.0);
  EXPECT_NEAR(sum / kDraws, 4.0, 5.0 * 2.0 / std::sqrt(kDraws));
  EXPECT_EQ(random.poisson(0.0), 0);
}

TEST(Random, IndexReachesEveryValueAndNoOther) {
  Random random(4);
  std::vector<int> seen(5, 0);
  for (int i = 0; i < 1000; ++i) ++seen.at(static_cast<std::size_t>(random.index(5)));
  for (const int count : seen) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace lookout::core
