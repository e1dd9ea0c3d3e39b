#include "tracking/initiation/initiator_config.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "tests/support/reading.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

/// As for no initiator in particular: every common key is accepted.
InitiatorConfig read(const std::string& text) {
  const auto of_all = [](const core::YamlMap& map, InitiatorConfig& config) {
    std::vector<InitiatorKey> keys;
    for (const auto& name : common_initiator_keys()) keys.push_back({.name = name});
    read_initiator_config(map, keys, config);
  };
  return testing::read_yaml<InitiatorConfig>(of_all, text);
}

TEST(InitiatorConfig, ReadsItsKeysWithTheirUnits) {
  const InitiatorConfig config =
      read("{range_sigma: 10.0, azimuth_sigma_deg: 0.3, min_speed: 333, max_speed: 750}");
  EXPECT_NEAR(*config.azimuth_sigma, 0.005235987755982988, 1e-15);  // 0.3 degrees
  EXPECT_DOUBLE_EQ(*config.max_speed, 750.0);
  EXPECT_FALSE(config.window_scans);
  EXPECT_NEAR(*read("{max_turn_deg: 180}").max_turn, std::numbers::pi, 1e-15);
  EXPECT_EQ(*read("{gate_margin: 12.5}").gate_margin, 12.5);
}

TEST(InitiatorConfig, RefusesUnknownKeysAndValuesOutOfRange) {
  EXPECT_THROW(read("{min_sped: 3}"), core::InputError);
  EXPECT_THROW(read("{min_speed: 5, max_speed: 4}"), core::InputError);
  EXPECT_THROW(read("{window_scans: 1}"), core::InputError);
  EXPECT_THROW(read("{max_turn_deg: 181}"), core::InputError);
  EXPECT_THROW(read("{gate_margin: -1}"), core::InputError);
  EXPECT_THROW(read("{range_sigma: 10}"), core::InputError);
  EXPECT_THROW(read("{peak_threshold: 1.5}"), core::InputError);
}

TEST(InitiatorConfig, ReadsAKeyOfAnInitiatorsOwn) {
  const auto reader = [](const core::YamlMap& map, InitiatorConfig& config) {
    const std::vector<InitiatorKey> keys{{"shyness", {0.0, 2.0}}, {"min_plots"}};
    read_initiator_config(map, keys, config);
  };
  const auto config = testing::read_yaml<InitiatorConfig>(reader, "{shyness: 1.5, min_plots: 4}");
  EXPECT_EQ(config.own_number("shyness", 0.0), 1.5);
  EXPECT_EQ(config.min_plots, 4);
  EXPECT_EQ(config.own_number("boldness", 0.25), 0.25);
  EXPECT_THROW(testing::read_yaml<InitiatorConfig>(reader, "{shyness: 3}"), core::InputError);
  EXPECT_THROW(testing::read_yaml<InitiatorConfig>(reader, "{rho_step: 3}"), core::InputError);
}

/// At 70 km 0.3 degrees are 366.5 m across, [Zeng2023].
TEST(InitiatorConfig, PolarNoiseLiesAlongAndAcrossTheLineOfSight) {
  const Eigen::Matrix2d noise = polar_noise({0.0, 70e3}, 10.0, 0.3 * 3.14159265358979 / 180.0);
  EXPECT_NEAR(std::sqrt(noise(0, 0)), 366.5, 0.1);
  EXPECT_NEAR(std::sqrt(noise(1, 1)), 10.0, 1e-9);
  EXPECT_GT(polar_noise({0.0, 0.0}, 10.0, 0.005).determinant(), 0.0);
}

TEST(InitiatorRegistry, MakesEveryNameAndRefusesOthers) {
  EXPECT_FALSE(initiator_names().empty());
  for (const auto& name : initiator_names()) EXPECT_NE(make_initiator(name, {}), nullptr);
  EXPECT_THROW(make_initiator("hough", {}), std::invalid_argument);
  InitiatorConfig config;
  config.variant = "printed";
  for (const auto& name : initiator_names())
    EXPECT_THROW(make_initiator(name, config), std::invalid_argument) << name;
}

}  // namespace
}  // namespace lookout::tracking
