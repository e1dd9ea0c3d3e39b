#include "tracking/detection/detection_params.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "core/files/yaml_reader.hpp"
#include "core/frames.hpp"
#include "core/input_error.hpp"

namespace lookout::tracking {
namespace {

DetectionParams read(const std::string& text) {
  DetectionParams params;
  read_detection_params(core::YamlMap::load_text(text, "c.yaml"), params);
  return params;
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DetectionParams, TheDefaultsAreValid) {
  EXPECT_NO_THROW(check(DetectionParams{}));
}

TEST(DetectionParams, ReadsEveryKey) {
  const DetectionParams params = read(
      "{method: smallest_of, values: power, pulse_length: 0.5, beam_width_deg: 1.5, guard: 3, "
      "range_extent: 9, beam_extent: 2, valley_db: 4, sidelobe_db: -8, background_memory: 0, "
      "false_alarm_rate: 0.05, law_memory: 20, zones: 2, max_returns: 50}");
  EXPECT_EQ(params.values, ImageValues::power);
  EXPECT_EQ(params.echo.pulse_length, 0.5);
  EXPECT_DOUBLE_EQ(params.echo.beam_width.value(), core::radians(1.5));
  EXPECT_EQ(params.echo.valley_db, 4.0);
  EXPECT_EQ(params.echo.sidelobe_db, -8.0);
  EXPECT_EQ(params.reference.method, "smallest_of");
  EXPECT_EQ(params.reference.guard, 3.0);
  EXPECT_EQ(params.reference.range_extent, 9.0);
  EXPECT_EQ(params.reference.beam_extent, 2.0);
  EXPECT_EQ(params.background.memory_pings, 0.0);
  EXPECT_EQ(params.false_alarm.rate, 0.05);
  EXPECT_EQ(params.false_alarm.memory_pings, 20.0);
  EXPECT_EQ(params.false_alarm.zones, 2);
  EXPECT_EQ(params.max_returns, 50);
  EXPECT_EQ(read("{method: ordered_statistic, quantile: 0.6}").reference.quantile, 0.6);
}

TEST(DetectionParams, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(refusal("{metod: smallest_of}").find("metod"), std::string::npos);
  EXPECT_NE(refusal("{method: median}").find("ordered_statistic"), std::string::npos);
  EXPECT_NE(refusal("{false_alarm_rate: 0}").find("false_alarm_rate"), std::string::npos);
  EXPECT_NE(refusal("{background_memory: 0.5}").find("background_memory"), std::string::npos);
}

TEST(DetectionParams, RefusesAKeyWithoutEffect) {
  EXPECT_NE(refusal("{method: cell_averaging, quantile: 0.5}").find("no effect"), std::string::npos);
}

TEST(DetectionParams, RefusesParametersOutOfRange) {
  DetectionParams params;
  params.false_alarm.rate = 0.0;
  EXPECT_THROW(check(params), std::invalid_argument);
  params = {};
  params.reference.guard = 0.5;
  EXPECT_THROW(check(params), std::invalid_argument);
  params = {};
  params.max_returns = 2701;
  EXPECT_THROW(check(params), std::invalid_argument);
  params = {};
  params.echo.pulse_length = 0.0;
  EXPECT_THROW(check(params), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
