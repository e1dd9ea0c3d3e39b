#include "tools/experiments/fusion/fused_run.hpp"

#include <gtest/gtest.h>

#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

sonar_sim::Scene short_scene() {
  auto scene = sonar_sim::load_scene(tools_directory() + "/scenarios/two_uuv.yaml");
  scene.duration = 15.0;
  return scene;
}

FusedRunParams plain() {
  FusedRunParams params;
  params.tracker = "gnn";
  return params;
}

TEST(FusedRun, OnePictureATimeWithinTheLinksRate) {
  const auto run = run_fused(short_scene(), plain(), 1000, 0);
  ASSERT_EQ(run.scans.size(), 30u);
  ASSERT_EQ(run.links.size(), 2u);
  for (const auto& link : run.links) EXPECT_LE(link.most_bytes_in_a_second, 256);
  EXPECT_EQ(run.scans[0].own_truth.size(), 2u);
}

TEST(FusedRun, WhatEitherSeesIsVisible) {
  for (const auto& scan : run_fused(short_scene(), plain(), 1000, 0).scans) {
    for (std::size_t k = 0; k < scan.truth.targets.size(); ++k) {
      const bool either = scan.own_truth[0].targets[k].visible || scan.own_truth[1].targets[k].visible;
      EXPECT_EQ(scan.truth.targets[k].visible, either);
    }
  }
}

TEST(FusedRun, ADeadNodeReportsNothingWhileItIsDead) {
  auto params = plain();
  params.outage = {2, 5.0, 10.0};
  const auto scans = run_fused(short_scene(), params, 1000, 0).scans;
  for (std::size_t k = 10; k < 20; ++k) EXPECT_TRUE(scans[k].own_tracks[1].empty()) << k;
}

TEST(FusedRun, AnAcousticLinkCarriesThirtyTwoBytesATurn) {
  auto params = plain();
  params.acoustic = {5.0, 0.0, 1.0};
  const auto run = run_fused(short_scene(), params, 1000, 0);
  for (const auto& link : run.links) {
    EXPECT_EQ(link.most_bytes_in_a_second, 32);
    EXPECT_LE(link.bytes_per_second * 15.0, 32.0 * 3.0);  // Three turns in fifteen seconds.
  }
}

TEST(FusedRun, ALinkThatLosesAllShowsNothing) {
  auto params = plain();
  params.acoustic = {5.0, 1.0, 0.0};
  for (const auto& scan : run_fused(short_scene(), params, 1000, 0).scans) EXPECT_TRUE(scan.fused.empty());
}

TEST(FusedRun, SameSeedSamePicture) {
  const auto a = run_fused(short_scene(), plain(), 1000, 1), b = run_fused(short_scene(), plain(), 1000, 1);
  ASSERT_EQ(a.scans.back().fused.size(), b.scans.back().fused.size());
  for (std::size_t k = 0; k < a.scans.back().fused.size(); ++k)
    EXPECT_EQ(a.scans.back().fused[k].state, b.scans.back().fused[k].state);
}

}  // namespace
}  // namespace lookout::tools
