#include "tracking/baselines/gaussian/association_marginals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr double kExact = 1e9, kNever = 0.0;  // Events of a cluster that are summed: all, none.

/// Oracle: every assignment of returns to tracks, by counting in base returns + 1.
struct Enumerated {
  std::vector<double> pair;
  std::vector<double> missed;
};

Enumerated enumerate(const std::vector<AssociationPair>& pairs, int num_tracks, int num_returns) {
  Enumerated sums{std::vector<double>(pairs.size(), 0.0),
                  std::vector<double>(static_cast<std::size_t>(num_tracks), 0.0)};
  double total = 0.0;
  const int base = num_returns + 1;
  const int events = static_cast<int>(std::lround(std::pow(base, num_tracks)));
  for (int code = 0; code < events; ++code) {
    std::vector<int> choice;  // 0: none, j + 1: return j
    for (int left = code, t = 0; t < num_tracks; ++t, left /= base) choice.push_back(left % base);
    double weight = 1.0;
    for (std::size_t a = 0; a < choice.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b)
        if (choice[a] > 0 && choice[a] == choice[b]) weight = 0.0;
      double ratio = choice[a] == 0 ? 1.0 : 0.0;
      for (const auto& pair : pairs)
        if (pair.track == static_cast<int>(a) && pair.detection == choice[a] - 1) ratio = pair.ratio;
      weight *= ratio;
    }
    total += weight;
    for (std::size_t t = 0; t < choice.size(); ++t)
      if (choice[t] == 0) sums.missed[t] += weight;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if (choice[static_cast<std::size_t>(pairs[k].track)] == pairs[k].detection + 1) sums.pair[k] += weight;
  }
  for (double& value : sums.pair) value /= total;
  for (double& value : sums.missed) value /= total;
  return sums;
}

std::vector<AssociationPair> random_pairs(int num_tracks, int num_returns, core::Random& random) {
  std::vector<AssociationPair> pairs;
  for (int t = 0; t < num_tracks; ++t)
    for (int j = 0; j < num_returns; ++j)
      if (random.bernoulli(0.6)) pairs.push_back({t, j, std::exp(random.uniform(-3.0, 3.0))});
  return pairs;
}

TEST(AssociationMarginals, OneTrackTwoReturns) {
  AssociationMarginals marginals(kExact);
  const std::vector<AssociationPair> pairs{{0, 0, 2.0}, {0, 1, 1.0}};
  marginals.solve(pairs, 1, 2);
  EXPECT_DOUBLE_EQ(marginals.missed(0), 0.25);  // 1 : 2 : 1
  EXPECT_DOUBLE_EQ(marginals.pair(0), 0.5);
  EXPECT_DOUBLE_EQ(marginals.unclaimed(1), 0.75);
}

TEST(AssociationMarginals, EqualsEnumeration) {
  core::Random random(7);
  AssociationMarginals marginals(kExact);
  for (int trial = 0; trial < 60; ++trial) {
    const int tracks = 1 + random.index(4), returns = 1 + random.index(4);
    const auto pairs = random_pairs(tracks, returns, random);
    marginals.solve(pairs, tracks, returns);
    const Enumerated oracle = enumerate(pairs, tracks, returns);
    for (std::size_t k = 0; k < pairs.size(); ++k) EXPECT_NEAR(marginals.pair(k), oracle.pair[k], 1e-12);
    for (int t = 0; t < tracks; ++t)
      EXPECT_NEAR(marginals.missed(t), oracle.missed[static_cast<std::size_t>(t)], 1e-12);
  }
}

TEST(AssociationMarginals, PropagationIsExactWithoutLoops) {
  // A chain: track 0 - return 0 - track 1 - return 1 - track 2. [Williams2014] is exact on trees.
  const std::vector<AssociationPair> pairs{{0, 0, 2.0}, {1, 0, 0.7}, {1, 1, 3.0}, {2, 1, 5.0}};
  AssociationMarginals marginals(kNever);
  marginals.solve(pairs, 3, 2);
  const Enumerated oracle = enumerate(pairs, 3, 2);
  for (std::size_t k = 0; k < pairs.size(); ++k) EXPECT_NEAR(marginals.pair(k), oracle.pair[k], 1e-6);
}

TEST(AssociationMarginals, PropagationIsNearWithLoops) {
  core::Random random(8);
  AssociationMarginals marginals(kNever);
  double worst = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto pairs = random_pairs(3, 3, random);
    marginals.solve(pairs, 3, 3);
    const Enumerated oracle = enumerate(pairs, 3, 3);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      worst = std::max(worst, std::abs(marginals.pair(k) - oracle.pair[k]));
  }
  EXPECT_LT(worst, 0.15);  // loose: belief propagation is biased where three tracks fight for three returns
}

TEST(AssociationMarginals, ClustersDoNotMix) {
  const std::vector<AssociationPair> pairs{{0, 0, 2.0}, {1, 1, 3.0}, {2, 0, 2.0}};
  AssociationMarginals marginals(kExact);
  marginals.solve(pairs, 3, 3);
  EXPECT_DOUBLE_EQ(marginals.pair(1), 0.75);
  EXPECT_DOUBLE_EQ(marginals.pair(0), 0.4);  // 1 : 2 : 2
  EXPECT_DOUBLE_EQ(marginals.unclaimed(2), 1.0);
}

}  // namespace
}  // namespace lookout::tracking
