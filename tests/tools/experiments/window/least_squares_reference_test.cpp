#include "tools/experiments/window/least_squares_reference.hpp"

#include <gtest/gtest.h>

#include "sonar_sim/scene.hpp"

namespace lookout::tools {
namespace {

const core::SonarParams& sonar_of(const sonar_sim::Scene& scene) {
  return scene.platforms.front().sonar.params;
}

// No misses, no clutter, no range error, true bearings: least squares on the own detections is the truth.
TEST(LeastSquaresReference, IsTheTruthWithoutErrors) {
  auto scene = load_variant("window_table2.yaml", {0.0, 0.0, 3.0, sonar_sim::ClutterReading::light});
  scene.platforms.front().sonar.echo_range_sigma = 0.0;
  scene.platforms.front().sonar.quantise_bearing = false;
  const auto scans = simulate(scene, 1000, 0);
  const auto fits = least_squares_reference(scans, sonar_of(scene));
  ASSERT_EQ(fits.size(), 3U);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const auto& truth = scans.back().truth.targets[k];
    EXPECT_EQ(fits[k].id, truth.id);
    EXPECT_LT((fits[k].state.head<2>() - truth.position).norm(), 1e-6);
    EXPECT_LT((fits[k].state.tail<2>() - truth.velocity).norm(), 1e-6);
  }
}

// The association is by the truth: clutter in other beams changes nothing.
TEST(LeastSquaresReference, DoesNotSeeClutter) {
  auto scene = load_variant("window_table2.yaml", {0.0, 0.1, 3.0, sonar_sim::ClutterReading::light});
  auto scans = simulate(scene, 1000, 0);
  const auto clean = least_squares_reference(scans, sonar_of(scene));
  for (auto& timed : scans) timed.posed.scan.returns.push_back({core::radians(-44.5), 30.0, 1.0});
  const auto cluttered = least_squares_reference(scans, sonar_of(scene));
  ASSERT_EQ(clean.size(), cluttered.size());
  for (std::size_t k = 0; k < clean.size(); ++k) EXPECT_EQ(clean[k].state, cluttered[k].state);
}

}  // namespace
}  // namespace lookout::tools
