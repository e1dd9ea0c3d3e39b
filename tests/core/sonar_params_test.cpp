#include "core/sonar_params.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/files/yaml_reader.hpp"
#include "core/input_error.hpp"
#include "tests/support/reading.hpp"

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
  params.wander = 0.14;
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
  EXPECT_EQ(back.wander, 0.14);
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
  EXPECT_THROW(read("bearing_step_deg: 1e-308"), InputError);  // No number of beams is a float then.
  EXPECT_THROW(read("clutter_per_scan: 1\nfalse_alarm_probability: 0.1"), InputError);
  EXPECT_THROW(read("max_ragne: 5"), InputError);
}

/// Params from the text of a sonar.yaml.
SonarParams read(const std::string& text, SonarParams params = {}) {
  read_sonar_params(YamlMap::load_text(text, "t"), params);
  return params;
}

TEST(SonarParams, UnevenBeamsAreReadFromPortAndCountByTheirCentres) {
  for (const std::string text :
       {"beam_bearings_deg: [-10, -2, 0, 10]", "beam_bearings_deg: [10, 0, -2, -10]"}) {
    const SonarParams params = read(text);
    EXPECT_EQ(params.num_beams, 4);
    EXPECT_DOUBLE_EQ(params.first_bearing, radians(-10.0));
    EXPECT_DOUBLE_EQ(degrees(params.bearing_step), 20.0 / 3.0);
    EXPECT_EQ(params.beam_of(radians(-5.9)), 1);
    EXPECT_DOUBLE_EQ(params.beam_centre(1), radians(-2.0));
    EXPECT_NEAR(degrees(params.left_edge()), -14.0, 1e-12);
    EXPECT_NEAR(degrees(params.right_edge()), 15.0, 1e-12);
  }
}

TEST(SonarParams, ABearingIsAsUncertainAsItsBeamIsWide) {
  const SonarParams params = read("beam_bearings_deg: [-10, -2, 0, 10]");
  EXPECT_NEAR(degrees(params.bearing_sigma_at(1)), 5.0 / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(degrees(params.bearing_sigma_at(3)), 10.0 / std::sqrt(12.0), 1e-9);
  EXPECT_EQ(SonarParams().bearing_sigma_at(7), SonarParams().bearing_sigma_or_default());
}

TEST(SonarParams, UnevenBeamsReadBackToTheBit) {
  const SonarParams params = read("beam_bearings_deg: [-44.5, -43.248, -42.021, -30.7, -1.1, 0.3, 17.017]");
  const SonarParams back = read(to_yaml(params));
  EXPECT_TRUE(same_fan(back.fan.get(), params.fan.get()));
  EXPECT_EQ(back.first_bearing, params.first_bearing);
  EXPECT_EQ(back.bearing_step, params.bearing_step);
}

TEST(SonarParams, AnEvenFanOfALaterFileHoldsUnlessItIsTheMean) {
  const SonarParams uneven = read("beam_bearings_deg: [-10, -2, 0, 10]");
  EXPECT_TRUE(read("range_sigma: 1", uneven).fan);
  EXPECT_TRUE(read("first_bearing_deg: -10", uneven).fan);
  EXPECT_FALSE(read("num_beams: 20", uneven).fan);
  EXPECT_FALSE(read("bearing_step_deg: 2", uneven).fan);
}

TEST(SonarParams, RefusesBearingsThatAreNoFan) {
  const auto error = [](const std::string& text) { return testing::error_of([&] { read(text); }); };
  const auto says = [&](const std::string& text, const std::string& what) {
    EXPECT_NE(error("beam_bearings_deg: " + text).find(what), std::string::npos) << error(text);
  };
  says("[1, 0, 2]", "rise or fall");
  says("[0, 0]", "rise or fall");
  says("[0, 359.9]", "full turn");
  says("[0, 400]", "from -360 to 360");
  says("[3]", "at least two");
  says("[0, 1]\nnum_beams: 3", "is not the number of beam_bearings_deg");
  says("[0, 1]\nfirst_bearing_deg: 0", "excludes first_bearing_deg");
}

}  // namespace
}  // namespace lookout::core
