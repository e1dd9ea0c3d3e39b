#include "sonar_sim/sea/bursts.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

double p_f_at(double time, const Burst& burst) {
  core::SonarParams params;
  params.false_alarm_probability = 0.2;
  apply_bursts({burst}, time, params);
  return *params.false_alarm_probability;
}

TEST(Bursts, HoldFromTheirStartToTheirEnd) {
  const Burst burst{30.0, 3.0, 0.95, 1.0};
  EXPECT_EQ(p_f_at(29.9, burst), 0.2);
  EXPECT_EQ(p_f_at(30.0, burst), 0.95);
  EXPECT_EQ(p_f_at(32.9, burst), 0.95);
  EXPECT_EQ(p_f_at(33.0, burst), 0.2);
}

TEST(Bursts, AFactorMultipliesUpToCertainty) {
  EXPECT_DOUBLE_EQ(p_f_at(1.0, {0.0, 9.0, std::nullopt, 3.0}), 0.6);
  EXPECT_DOUBLE_EQ(p_f_at(1.0, {0.0, 9.0, std::nullopt, 10.0}), 1.0);
}

TEST(Bursts, AFactorMultipliesTheClutterOfAPointSensor) {
  core::SonarParams params;
  params.clutter_per_scan = 4.0;
  apply_bursts({{0.0, 9.0, std::nullopt, 10.0}}, 1.0, params);
  EXPECT_DOUBLE_EQ(*params.clutter_per_scan, 40.0);
}

}  // namespace
}  // namespace lookout::sonar_sim
