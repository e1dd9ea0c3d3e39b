#include "csht/joint/pair_seeds.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/frames.hpp"
#include "core/random.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

constexpr int kOwners = 4;

ScanLikelihood moving_target(int scans) {
  ScanLikelihood likelihood({}, {}, {}, 60, kOwners);
  for (int k = 0; k < scans; ++k) likelihood.push(scan_of(k, {{60.0 + 0.5 * k, 10.0}}));
  return likelihood;
}

TEST(PairSeeds, OneTargetIsOneGoodSeed) {
  ScanLikelihood likelihood = moving_target(20);
  PairSeeds birth({});
  const auto seeds = birth.propose(likelihood, TargetPrior());
  ASSERT_FALSE(seeds.empty());
  EXPECT_NEAR(seeds[0].guess.mean[0], 69.5, 1.0);
  EXPECT_NEAR(seeds[0].guess.mean[1], 10.0, 1.0);
  EXPECT_NEAR(seeds[0].guess.mean[2], 1.0, 0.3);
  EXPECT_NEAR(seeds[0].guess.mean[3], 0.0, 0.3);
  EXPECT_GT(seeds[0].log_odds, 10.0);
  for (std::size_t i = 1; i < seeds.size(); ++i) EXPECT_LE(seeds[i].log_odds, seeds[0].log_odds);
}

TEST(PairSeeds, WhatATrackClaimsIsNoSeed) {
  ScanLikelihood likelihood = moving_target(20);
  likelihood.set_existence(0, 1.0);
  for (int age = 0; age < 20; ++age) {
    const ScanTable& scan = likelihood.scans().at_age(age);
    const double range = scan.detections[0].range;
    likelihood.add_claim(age, {0, scan.detections[0].beam, static_cast<float>(range), 1.0F});
  }
  PairSeeds birth({});
  EXPECT_TRUE(birth.propose(likelihood, TargetPrior()).empty());
}

TEST(PairSeeds, AreNoneOnceTheWorkIsStopped) {
  ScanLikelihood likelihood = moving_target(20);
  PairSeeds birth({});
  for (const int stop_call : {1, 2, 5, 10}) {
    int calls = 0;
    EXPECT_TRUE(birth.propose(likelihood, TargetPrior(), [&] { return ++calls >= stop_call; }).empty());
    EXPECT_LE(calls, stop_call + 4);  // Each of the steps that are left asks once.
  }
  EXPECT_FALSE(birth.propose(likelihood, TargetPrior()).empty());
}

TEST(PairSeeds, OneScanHasNoPairs) {
  ScanLikelihood likelihood = moving_target(1);
  PairSeeds birth({});
  EXPECT_TRUE(birth.propose(likelihood, TargetPrior()).empty());
}

// In clutter a hundred times as dense a scan says 4.6 nats less of a detection, and more scans are weighed.
TEST(PairSeeds, InDenseClutterATargetIsWeighedOverMoreScans) {
  ScanLikelihood likelihood = moving_target(40);
  const int clear = birth_window(likelihood.scans(), {});
  EXPECT_GT(birth_window(likelihood.scans(), {}, 0.01), 2 * clear);
  const Eigen::Vector4d course(79.5, 10.0, 1.0, 0.0);
  EXPECT_EQ(background_along(course, likelihood.scans(), 20), 1.0);
  for (int age = 0; age < 40; ++age)
    likelihood.set_background(age,
                              std::vector<float>(likelihood.scans().at_age(age).background.size(), 0.01F));
  EXPECT_NEAR(background_along(course, likelihood.scans(), 20), 0.01, 1e-6);
  PairSeeds birth({});
  const auto seeds = birth.propose(likelihood, TargetPrior());
  ASSERT_FALSE(seeds.empty());
  EXPECT_GT(seeds[0].window, clear);
}

// 800 returns a scan make 6.4 million pairs with the ten scans before; a target among them is found all the
// same. The bound is that of pair_seeds.cpp.
TEST(PairSeeds, AreBoundedInAFlood) {
  ScanLikelihood likelihood({}, {}, {}, 60, kOwners);
  core::Random random(4);
  for (int k = 0; k < 12; ++k) {
    std::vector<Eigen::Vector2d> places{{8.0 + 0.5 * k, 0.0}};
    for (int i = 0; i < 800; ++i)
      places.push_back(core::from_polar(random.uniform(20.0, 140.0), random.uniform(-0.7, 0.7)));
    likelihood.push(scan_of(k, places));
  }
  PairSeeds birth({});
  const auto seeds = birth.propose(likelihood, TargetPrior());
  EXPECT_GT(birth.num_pairs(), 10'000u);
  EXPECT_LE(birth.num_pairs(), 32'768u);
  EXPECT_TRUE(std::any_of(seeds.begin(), seeds.end(), [](const BirthSeed& seed) {
    return (seed.guess.mean.head<2>() - Eigen::Vector2d(13.5, 0.0)).norm() < 2.0;
  }));
}

// Three exact detections of a line fix it: position at time 0 is 10, velocity 2.
TEST(LineFit, IsWeightedLeastSquares) {
  LineFit fit;
  for (int k = 0; k < 3; ++k) fit.add({10.0 - 2.0 * k, 5.0}, -1.0 * k, 0.3, 9.0, 1.0, 1.0);
  const Eigen::Vector4d state = fit.information.inverse() * fit.weighted;
  EXPECT_NEAR(state[0], 10.0, 1e-9);
  EXPECT_NEAR(state[1], 5.0, 1e-9);
  EXPECT_NEAR(state[2], 2.0, 1e-9);
}

}  // namespace
}  // namespace lookout::csht
