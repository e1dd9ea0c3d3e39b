#include "csht/likelihood/point_likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kMiss = 0.3, kResolution = 12.0;

/// A sensor without beams and these returns; the first is owned by another target with probability `share`.
struct Scene {
  ScanTable scan;
  BeamMask mask;
};

Scene scene_of(std::vector<core::SonarReturn> returns, double share, double resolution = kResolution) {
  Scene scene;
  fill_scan_table(posed_scan(std::move(returns)), scene.scan);
  SensorFigures figures{kMiss, 0.1, 4.0, 2.0, 0.02};
  figures.resolution = resolution;
  set_figures(figures, {.clutter = ClutterModel::point}, scene.scan);
  scene.mask.clear(scene.scan);
  claim_detection(0, share, scene.mask);
  return scene;
}

double ratio_at(const Scene& scene, double range, double bearing) {
  return plain_point_ratio(scene.scan, &scene.mask, range, bearing, {});
}

TEST(PointLikelihood, WithoutAReturnOfItsOwnATargetNearAnothersIsHidden) {
  const Scene scene = scene_of({{0.0, 80.0, 1}}, 1.0);
  // On the other's return all is hidden; at the resolution half of the time; at twice that, 1 time in 16.
  EXPECT_NEAR(ratio_at(scene, 80.0, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(ratio_at(scene, 92.0, 0.0), 0.5 * kMiss + 0.5, 1e-6);
  EXPECT_NEAR(ratio_at(scene, 80.0, 12.0 / 80.0), 0.5 * kMiss + 0.5, 1e-6);
  EXPECT_NEAR(ratio_at(scene, 56.0, 0.0), 15.0 / 16.0 * kMiss + 1.0 / 16.0, 1e-6);
}

TEST(PointLikelihood, NothingHidesWhereNobodyOwnsOrAllIsResolved) {
  for (const Scene& scene : {scene_of({{0.0, 80.0, 1}}, 0.0), scene_of({{0.0, 80.0, 1}}, 1.0, 0.0)})
    EXPECT_NEAR(ratio_at(scene, 100.0, 0.0), kMiss, 1e-6);  // Ten sigma off the return.
}

// A return of its own, 12 m beside the other's, is worth half of what it is worth alone.
TEST(PointLikelihood, AReturnOfItsOwnCountsAsFarAsBothAreResolved) {
  const Scene alone = scene_of({{-0.7, 20.0, 1}, {0.0, 92.0, 1}}, 1.0);
  const Scene beside = scene_of({{0.0, 80.0, 1}, {0.0, 92.0, 1}}, 1.0);
  EXPECT_NEAR(ratio_at(beside, 92.0, 0.0), 0.5 * ratio_at(alone, 92.0, 0.0) + 0.5, 1e-3);
}

TEST(PointLikelihood, FastAgreesWithPlain) {
  core::Random random(1003);
  std::vector<core::SonarReturn> returns;
  for (int k = 0; k < 12; ++k) returns.push_back({random.uniform(-0.7, 0.7), random.uniform(10.0, 140.0), 1});
  const Scene scene = scene_of(returns, 0.8);
  std::vector<float> range(kPointBlock), bearing(kPointBlock), ratio(kPointBlock);
  for (std::size_t i = 0; i < kPointBlock; ++i) {
    range[i] = static_cast<float>(random.uniform(1.0, 150.0));
    bearing[i] = static_cast<float>(random.uniform(-0.9, 0.9));
  }
  const Tolerance tolerance{1.5, 0.1};
  find_point_ratios(scene.scan, &scene.mask, range, bearing, tolerance, ratio);
  for (std::size_t i = 0; i < kPointBlock; ++i) {
    const double plain = plain_point_ratio(scene.scan, &scene.mask, range[i], bearing[i], tolerance);
    EXPECT_NEAR(std::log(ratio[i]), std::log(plain), 2e-3) << range[i] << " m, " << bearing[i];
  }
}

}  // namespace
}  // namespace lookout::csht
