#include "sonar_sim/image_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/beam_bearings.hpp"
#include "sonar_sim/sonar_simulator.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr int kDraws = 200000;

/// Second and fourth moment of the amplitude.
std::pair<double, double> moments(const std::optional<double>& shape, std::uint64_t seed) {
  core::Random random(seed);
  double second = 0.0, fourth = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double power = std::norm(draw_background(shape, random));
    second += power / kDraws;
    fourth += power * power / kDraws;
  }
  return {second, fourth};
}

TEST(ImageNoise, TheBackgroundHasUnitPowerAndTheMomentsOfItsLaw) {
  // K distribution of unit power: E a^4 = 2 (1 + 1 / shape); Rayleigh: 2.
  const auto [power_k, fourth_k] = moments(4.0, 1000);
  EXPECT_NEAR(power_k, 1.0, 0.015);
  EXPECT_NEAR(fourth_k, 2.5, 0.12);
  const auto [power_r, fourth_r] = moments(std::nullopt, 1001);
  EXPECT_NEAR(power_r, 1.0, 0.015);
  EXPECT_NEAR(fourth_r, 2.0, 0.08);
}

const char* const kScene = R"(
duration: 2.0
vehicle: {north_velocity: 1.5, yaw_swing_deg: 8.0, yaw_period: 4.0}
sonar: {miss_probability: 0.3, false_alarm_probability: 0.1}
image: {shape: 4.0, snr_db: 8.0}
targets:
  - {id: 7, north: 60.0, east: 10.0, snr_db: 40.0}
)";

TEST(ImageNoise, AStrongTargetIsTheBrightestCellWhereItIsSeen) {
  SonarSimulator simulator(parse_scene(kScene, "scene"), 1000);
  int pings = 0;
  while (const auto ping = simulator.next()) {
    ASSERT_TRUE(ping->image.has_value());
    const core::SonarImage& image = *ping->image;
    EXPECT_EQ(image.sequence, pings);
    EXPECT_EQ(image.utime, ping->scan.utime);
    const auto brightest = std::max_element(image.intensity.begin(), image.intensity.end());
    const auto cell = static_cast<int>(brightest - image.intensity.begin());
    const Eigen::Vector2d p_sonar =
        core::inverse_transform(ping->T_earth_sonar, ping->truth.targets[0].position);
    const double bearing = image.bearings[static_cast<std::size_t>(cell / image.num_bins)];
    const double range = image.first_range + (cell % image.num_bins) * image.range_step;
    EXPECT_NEAR(bearing, std::atan2(p_sonar.y(), p_sonar.x()), 0.6 * core::mean_step(image.bearings));
    EXPECT_NEAR(range, p_sonar.norm(), 0.6 * image.range_step);
    ++pings;
  }
  EXPECT_EQ(pings, 4);
}

TEST(ImageNoise, ImagesLeaveTheScansAsTheyWere) {
  Scene with = parse_scene(kScene, "scene"), without = with;
  without.platforms[0].image.reset();
  SonarSimulator a(with, 1000), b(without, 1000);
  while (const auto ping = a.next()) {
    const auto plain = b.next();
    EXPECT_FALSE(plain->image.has_value());
    ASSERT_EQ(ping->scan.returns.size(), plain->scan.returns.size());
    for (std::size_t i = 0; i < plain->scan.returns.size(); ++i)
      EXPECT_EQ(ping->scan.returns[i].range, plain->scan.returns[i].range);
  }
}

TEST(ImageNoise, TheLevelFollowsTheRange) {
  const ImagePlan plan;
  core::GroundTruth empty;
  core::Random random(1002);
  const core::SonarImage image = draw_image({}, plan, {}, empty, {}, random);
  for (const int bin : {2, 100, 290}) {
    double power = 0.0;
    for (int beam = 0; beam < 90; ++beam)
      for (int near = bin - 2; near <= bin + 2; ++near)
        power += image.at(beam, near) * image.at(beam, near) / 450;
    const double level = plan.background_level(image.first_range + bin * image.range_step);
    EXPECT_NEAR(std::sqrt(power) / level, 1.0, 0.15) << bin;  // 450 draws: 3 standard errors are 0.12
  }
}

}  // namespace
}  // namespace lookout::sonar_sim
