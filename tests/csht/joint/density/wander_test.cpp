#include "csht/joint/density/wander.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

constexpr double kRate = 0.2;

core::SonarParams point_sonar() {
  core::SonarParams sonar;
  sonar.clutter_per_scan = 3.0;
  sonar.miss_probability = 0.2;
  sonar.scan_period = 2.0;
  sonar.wander = kRate;
  return sonar;
}

TrajectoryCloud cloud_at_rest(std::size_t size) {
  TrajectoryCloud cloud;
  cloud.resize(size);
  for (const auto& component : {cloud.north, cloud.east}) EXPECT_EQ(component.size(), size);
  for (std::size_t i = 0; i < size; ++i) {
    cloud.north[i] = cloud.east[i] = cloud.north_velocity[i] = cloud.east_velocity[i] = 0.0;
    cloud.weight[i] = 1.0 / static_cast<double>(size);
  }
  return cloud;
}

// White noise acceleration of density q: variances q t of the velocity, q t^3 / 3 of the place, covariance q
// t^2 / 2.
TEST(Wander, ATrajectoryStraysAsWhiteNoiseAccelerationLetsIt) {
  TrajectoryCloud cloud = cloud_at_rest(20000);
  core::Random random(1, core::RandomStream::simulator);
  Wander(point_sonar()).stray(3.0, random, cloud);
  const TrajectoryCovariance covariance = cloud.moments().covariance;
  const double q = kRate * kRate;
  EXPECT_NEAR(covariance(2, 2), q * 3.0, 0.05 * q * 3.0);
  EXPECT_NEAR(covariance(0, 0), q * 9.0, 0.05 * q * 9.0);
  EXPECT_NEAR(covariance(0, 2), q * 4.5, 0.05 * q * 4.5);
  EXPECT_NEAR(covariance(0, 1), 0.0, 0.05 * q * 9.0);
}

TEST(Wander, NothingStraysWhereItIsNotStatedOrBeamsAre) {
  core::SonarParams beams = point_sonar();
  beams.clutter_per_scan.reset();
  EXPECT_FALSE(Wander(beams).active());
  EXPECT_FALSE(Wander().active());
  EXPECT_TRUE(std::isinf(Wander().memory({}, 100.0)));
  EXPECT_EQ(Wander().at_age(1000.0, 1.0, {}).sigma_scale, 1.0);
}

// 4 sigma^2 T / (q (1 - P_M)) = 4 x 4 x 2 / (.04 x .8) = 1000 s^4 where both errors are 2 m.
TEST(Wander, AReturnFadesInTheTimeThatErrorsAndWanderSet) {
  SensorFigures figures = figures_of(point_sonar());
  figures.range_sigma = 2.0;
  figures.bearing_sigma = 0.02;
  const double memory = Wander(point_sonar()).memory(figures, 100.0);
  EXPECT_NEAR(memory, std::pow(1000.0, 0.25), 1e-9);
  EXPECT_NEAR(Wander(point_sonar()).at_age(memory, memory, {}).sigma_scale, std::exp(0.5), 1e-9);
  EXPECT_NEAR(Wander(point_sonar()).at_age(0.0, memory, {}).sigma_scale, 1.0, 1e-12);
}

}  // namespace
}  // namespace lookout::csht
