#include "sonar_sim/sea/clutter_patches.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/field_of_view.hpp"
#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

ClutterPatch sonar_patch() {
  ClutterPatch patch;
  patch.first_bearing = core::radians(5.0);
  patch.last_bearing = core::radians(25.0);
  patch.nearest = 60.0;
  patch.farthest = 90.0;
  return patch;
}

ClutterPatch disc() {
  ClutterPatch patch;
  patch.on_earth = true;
  patch.centre = {80.0, 0.0};
  patch.radius = 20.0;
  return patch;
}

TEST(ClutterPatches, BeamsOfASonarPatchReturnUniformRanges) {
  const Ping ping = ping_at_origin();
  core::Random random(1);
  ClutterPatch patch = sonar_patch();
  patch.probability = 0.9;
  std::set<int> beams;
  double number = 0.0, sum = 0.0;
  for (int k = 0; k < kPings / 10; ++k)
    for (const auto& one : draw_patch(patch, ping, random)) {
      beams.insert(one.beam);
      ASSERT_TRUE(one.measured.range >= 60.0 && one.measured.range < 90.0);
      sum += one.measured.range;
      ++number;
    }
  EXPECT_EQ(beams.size(), 20u);  // beams 50 to 69
  EXPECT_EQ(*beams.begin(), 50);
  EXPECT_NEAR(number / (kPings / 10 * 20.0), 0.9, rate_tolerance(0.9, kPings / 10 * 20.0));
  EXPECT_NEAR(sum / number, 75.0, mean_tolerance(30.0 / std::sqrt(12.0), number));
}

TEST(ClutterPatches, MeanReturnsIsTheMeanOfAPoissonNumber) {
  const Ping ping = ping_at_origin();
  core::Random random(2);
  ClutterPatch patch = sonar_patch();
  patch.mean_returns = 400.0;  // twenty a beam
  double sum = 0.0, squares = 0.0;
  constexpr int kScans = 2000;
  for (int k = 0; k < kScans; ++k) {
    const double number = static_cast<double>(draw_patch(patch, ping, random).size());
    sum += number;
    squares += (number - 400.0) * (number - 400.0);
  }
  EXPECT_NEAR(sum / kScans, 400.0, mean_tolerance(20.0, kScans));
  EXPECT_NEAR(squares / kScans, 400.0, variance_tolerance(20.0, kScans));
}

TEST(ClutterPatches, ADiscLiesStillOnTheEarth) {
  Ping ping = ping_at_origin();
  ping.T_earth_sonar = {10.0, 5.0, core::radians(20.0)};
  core::Random random(3);
  ClutterPatch patch = disc();
  for (const bool by_number : {false, true}) {
    patch.probability = by_number ? std::nullopt : std::optional(1.0);
    patch.mean_returns = by_number ? std::optional(50.0) : std::nullopt;
    for (const auto& one : draw_patch(patch, ping, random)) {
      const auto p_earth =
          core::transform(ping.T_earth_sonar, core::from_polar(one.measured.range, one.measured.bearing));
      // A return stands at its beam's centre: half a degree at 95 m is .8 m.
      EXPECT_LT((p_earth - patch.centre).norm(), 20.0 + 0.9);
    }
  }
}

TEST(ClutterPatches, ADiscIsFilledUniformly) {
  Ping ping = ping_at_origin();
  ping.quantise_bearing = false;
  core::Random random(4);
  ClutterPatch patch = disc();
  patch.mean_returns = 50.0;
  double number = 0.0, inner = 0.0;
  for (int k = 0; k < 2000; ++k)
    for (const auto& one : draw_patch(patch, ping, random)) {
      inner += (core::from_polar(one.measured.range, one.measured.bearing) - patch.centre).norm() < 10.0
                   ? 1.0
                   : 0.0;
      ++number;
    }
  EXPECT_NEAR(inner / number, 0.25, rate_tolerance(0.25, number));  // half the radius, a quarter of the area
}

TEST(ClutterPatches, OutOfViewIsNotHeard) {
  Ping ping = ping_at_origin();
  ping.T_earth_sonar.heading = core::radians(180.0);
  core::Random random(5);
  ClutterPatch patch = disc();
  patch.mean_returns = 50.0;
  EXPECT_TRUE(draw_patch(patch, ping, random).empty());
  patch.mean_returns.reset();
  patch.probability = 1.0;
  EXPECT_TRUE(draw_patch(patch, ping, random).empty());
}

}  // namespace
}  // namespace lookout::sonar_sim
