#include "csht/likelihood/sensor_units.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

core::SonarParams radar() {
  core::SonarParams sonar;
  sonar.range_sigma = 4.0;
  sonar.max_speed = 8.0;
  sonar.scan_period = 2.0;
  return sonar;
}

TEST(SensorUnits, TimeIsTheFastestTargetsWayThroughARangeSigma) {
  EXPECT_DOUBLE_EQ(unit_of_time(radar()), 0.5);
}

TEST(SensorUnits, TimeStaysBetweenAMillisecondAndAThousandSeconds) {
  core::SonarParams sonar = radar();
  sonar.range_sigma = 1e-6;
  EXPECT_DOUBLE_EQ(unit_of_time(sonar), 1e-3);
  sonar.range_sigma = 1e9;
  EXPECT_DOUBLE_EQ(unit_of_time(sonar), 1e3);
}

TEST(SensorUnits, SlowScansLengthenATime) {
  EXPECT_DOUBLE_EQ(sensor_seconds(4.0, 8.0, radar()), 16.0);   // Eight scans of 2 s.
  EXPECT_DOUBLE_EQ(sensor_seconds(40.0, 8.0, radar()), 20.0);  // Forty times half a second.
}

}  // namespace
}  // namespace lookout::csht
