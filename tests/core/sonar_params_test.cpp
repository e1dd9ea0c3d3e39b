#include "core/sonar_params.hpp"

#include <gtest/gtest.h>

#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"

namespace lookout::core {
namespace {

TEST(SonarParams, DefaultsAreTableOne) {
  // [Yan2018] Table 1: 90 beams of 1 deg over 90 deg, 150 m.
  const SonarParams params;
  EXPECT_NEAR(degrees(params.left_edge()), -45.0, 1e-9);
  EXPECT_NEAR(degrees(params.right_edge()), 45.0, 1e-9);
  EXPECT_NEAR(degrees(params.bearing_sigma_or_default()), 0.2887, 1e-4);  // 1 / sqrt(12)
}

TEST(SonarParams, BeamOfABearing) {
  const SonarParams params;
  EXPECT_EQ(params.beam_of(radians(-44.99)), 0);
  EXPECT_EQ(params.beam_of(radians(44.99)), 89);
  EXPECT_EQ(params.beam_of(radians(0.01)), 45);
  EXPECT_EQ(params.beam_of(radians(-45.01)), -1);
  EXPECT_EQ(params.beam_of(radians(45.01)), -1);
}

TEST(SonarParams, BeamOfAFullCircleWrapsBehind) {
  SonarParams params;
  params.num_beams = 360;
  params.first_bearing = radians(-179.5);
  EXPECT_EQ(params.beam_of(radians(179.9)), 359);
  EXPECT_EQ(params.beam_of(radians(-179.9)), 0);
}

TEST(SonarParams, YamlReadsBackToTheSameValues) {
  SonarParams params;
  params.T_body_sonar = {0.5, -0.25, radians(10.0)};
  params.miss_probability = 0.3;
  params.clutter_per_scan = 3.0;
  params.bearing_sigma = radians(0.5);
  params.heading_sigma = radians(1.0);
  params.position_sigma = 0.5;
  params.latency = 1.25;
  params.resolution = 12.0;
  SonarParams back;
  read_sonar_params(YamlMap::load_text(to_yaml(params), "t"), back);
  EXPECT_EQ(back.num_beams, params.num_beams);
  EXPECT_NEAR(back.T_body_sonar.heading, params.T_body_sonar.heading, 1e-15);
  EXPECT_EQ(back.miss_probability, params.miss_probability);
  EXPECT_EQ(back.clutter_per_scan, params.clutter_per_scan);
  EXPECT_NEAR(*back.bearing_sigma, *params.bearing_sigma, 1e-15);
  EXPECT_NEAR(back.heading_sigma, params.heading_sigma, 1e-15);
  EXPECT_EQ(back.position_sigma, 0.5);
  EXPECT_EQ(back.latency, 1.25);
  EXPECT_EQ(back.resolution, 12.0);
  EXPECT_FALSE(back.false_alarm_probability);
}

TEST(SonarParams, RefusesWhatNoSensorHasWithLineAndKey) {
  for (const std::string text : {"max_range: 300000", "max_range: 1e300", "range_sigma: 0.001",
                                 "scan_period: 1e-5", "scan_period: 1e9", "mount_x: 1e5"}) {
    SonarParams params;
    EXPECT_THROW(read_sonar_params(YamlMap::load_text(text, "t"), params), InputError) << text;
  }
}

TEST(SonarParams, LaterKindOfClutterWins) {
  SonarParams params;
  params.false_alarm_probability = 0.3;
  read_sonar_params(YamlMap::load_text("clutter_per_scan: 3", "t"), params);
  EXPECT_TRUE(params.point_sensor());
  EXPECT_FALSE(params.false_alarm_probability);
}

TEST(SonarParams, RefusesWhatMakesNoSensor) {
  SonarParams params;
  const auto read = [&](const char* text) { read_sonar_params(YamlMap::load_text(text, "t"), params); };
  EXPECT_THROW(read("max_range: -5"), InputError);
  EXPECT_THROW(read("miss_probability: 1.2"), InputError);
  EXPECT_THROW(read("num_beams: 400"), InputError);
  EXPECT_THROW(read("clutter_per_scan: 1\nfalse_alarm_probability: 0.1"), InputError);
  EXPECT_THROW(read("max_ragne: 5"), InputError);
}

}  // namespace
}  // namespace lookout::core
