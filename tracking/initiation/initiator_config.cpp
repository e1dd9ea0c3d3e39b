#include "tracking/initiation/initiator_config.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "core/files/yaml_reader.hpp"
#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

void require_positive(const std::optional<double>& value, const char* field) {
  if (value) core::require_positive(field, *value);
}

using Config = InitiatorConfig;
constexpr core::Range kShare{0.0, 1.0, true};
constexpr double kDegree = core::radians(1.0);
constexpr double kMostCounted = 1e6;  // Scans, plots or tracks.

/// A common key that reads a number; what is read times `unit` is SI.
struct NumberKey {
  const char* name;
  std::optional<double> Config::*field;
  core::Range accepted;
  double unit = 1.0;
};

/// A common key that reads a whole number.
struct CountKey {
  const char* name;
  std::optional<int> Config::*field;
  int least;
};

constexpr NumberKey kNumberKeys[] = {
    {"range_sigma", &Config::range_sigma, core::kPositive},
    {"azimuth_sigma_deg", &Config::azimuth_sigma, core::kPositive, kDegree},
    {"min_speed", &Config::min_speed, core::kNotNegative},
    {"max_speed", &Config::max_speed, core::kPositive},
    {"acceleration_sigma", &Config::acceleration_sigma, core::kNotNegative},
    {"gate_margin", &Config::gate_margin, core::kNotNegative},
    {"max_turn_deg", &Config::max_turn, {0.0, 180.0, true}, kDegree},
    {"max_turn_rate_deg", &Config::max_turn_rate, {0.0, 18.0}, kDegree},
    {"rho_step", &Config::rho_step, core::kPositive},
    {"theta_step_deg", &Config::theta_step, {0.0, 45.0, true}, kDegree},
    {"rho_tolerance", &Config::rho_tolerance, core::kPositive},
    {"theta_tolerance_deg", &Config::theta_tolerance, core::kPositive, kDegree},
    {"sensor_range", &Config::sensor_range, core::kPositive},
    {"peak_threshold", &Config::peak_threshold, kShare},
    {"gate_probability", &Config::gate_probability, {0.0, 0.999999999, true}},
    {"max_false_tracks", &Config::max_false_tracks, core::kPositive},
    {"clutter_per_area", &Config::clutter_per_area, core::kPositive},
};

constexpr CountKey kCountKeys[] = {
    {"window_scans", &Config::window_scans, 2},
    {"min_plots", &Config::min_plots, 2},
    {"min_hits", &Config::min_hits, 2},
    {"max_tracks", &Config::max_tracks, 1},
};

constexpr const char* kVariant = "variant";
constexpr const char* kPositionSigma = "position_sigma";

/// @return whether it is a key of that kind.
bool read_number(const core::YamlMap& map, const std::string& name, Config& config) {
  for (const NumberKey& key : kNumberKeys) {
    if (name != key.name) continue;
    if (const auto given = map.optional_number(name, key.accepted)) config.*key.field = *given * key.unit;
    return true;
  }
  return false;
}

/// @return whether it is a key of that kind.
bool read_count(const core::YamlMap& map, const std::string& name, Config& config) {
  for (const CountKey& key : kCountKeys) {
    if (name != key.name) continue;
    const core::Range accepted{static_cast<double>(key.least), kMostCounted};
    if (map.has(name)) config.*key.field = map.integer(name, key.least, accepted);
    return true;
  }
  return false;
}

void read_key(const core::YamlMap& map, const InitiatorKey& key, Config& config) {
  if (key.name == kVariant)
    config.variant = map.text(key.name, config.variant);
  else if (key.name == kPositionSigma)
    config.position_sigma = map.number(key.name, config.position_sigma, core::kPositive);
  else if (!read_number(map, key.name, config) && !read_count(map, key.name, config))
    if (const auto given = map.optional_number(key.name, key.accepted)) config.own[key.name] = *given;
}

}  // namespace

Eigen::Matrix2d polar_noise(const Eigen::Vector2d& offset, double range_sigma, double azimuth_sigma) {
  const double range = offset.norm();
  if (range == 0.0) return range_sigma * range_sigma * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d along = offset / range;
  const Eigen::Vector2d across(-along.y(), along.x());
  constexpr double kLeastAcross = 1e-3;  // Of the range error, so that it is never 0 at the sensor itself.
  const double across_sigma = std::max(range * azimuth_sigma, kLeastAcross * range_sigma);
  return range_sigma * range_sigma * along * along.transpose() +
         across_sigma * across_sigma * across * across.transpose();
}

Eigen::Matrix2d InitiatorConfig::noise_at(const Eigen::Vector2d& position) const {
  if (range_sigma && azimuth_sigma) return polar_noise(position, *range_sigma, *azimuth_sigma);
  return position_sigma * position_sigma * Eigen::Matrix2d::Identity();
}

double InitiatorConfig::own_number(const std::string& key, double fallback) const {
  const auto given = own.find(key);
  return given == own.end() ? fallback : given->second;
}

void InitiatorConfig::validate() const {
  require_positive(position_sigma, "position_sigma");
  require_positive(range_sigma, "range_sigma");
  require_positive(azimuth_sigma, "azimuth_sigma");
  if (range_sigma.has_value() != azimuth_sigma.has_value())
    throw std::invalid_argument("range_sigma and azimuth_sigma must be given together, or neither");
  if (min_speed) core::require_not_negative("min_speed", *min_speed);
  if (max_speed)
    core::require(*max_speed > min_speed.value_or(0.0), "max_speed must be > min_speed", *max_speed);
  if (acceleration_sigma) core::require_not_negative("acceleration_sigma", *acceleration_sigma);
  if (gate_margin) core::require_not_negative("gate_margin", *gate_margin);
  if (max_turn)
    core::require(*max_turn > 0.0 && *max_turn <= std::numbers::pi, "max_turn must be in (0, pi]", *max_turn);
  if (window_scans) core::require(*window_scans >= 2, "window_scans must be >= 2", *window_scans);
  if (min_plots) core::require(*min_plots >= 2, "min_plots must be >= 2", *min_plots);
  if (min_hits) core::require(*min_hits >= 2, "min_hits must be >= 2", *min_hits);
  require_positive(rho_step, "rho_step");
  require_positive(rho_tolerance, "rho_tolerance");
  require_positive(theta_tolerance, "theta_tolerance");
  require_positive(sensor_range, "sensor_range");
  require_positive(max_false_tracks, "max_false_tracks");
  require_positive(clutter_per_area, "clutter_per_area");
  if (theta_step)
    core::require(*theta_step > 0.0 && *theta_step <= std::numbers::pi / 4, "theta_step must be in (0, pi/4]",
                  *theta_step);
  if (peak_threshold) core::require_share("peak_threshold", *peak_threshold);
  if (gate_probability) core::require_inner_share("gate_probability", *gate_probability);
  if (max_tracks) core::require(*max_tracks >= 1, "max_tracks must be >= 1", *max_tracks);
}

std::string chosen_variant(const InitiatorConfig& config, const std::string& method,
                           std::initializer_list<const char*> accepted) {
  if (config.variant.empty()) return accepted.size() > 0 ? *accepted.begin() : "";
  std::string names;
  for (const char* name : accepted) {
    if (config.variant == name) return name;
    names += std::string(" ") + name;
  }
  throw std::invalid_argument("variant of " + method + " must be one of" + (names.empty() ? " none" : names) +
                              ", got `" + config.variant + "`");
}

SpeedLimits speed_limits(const InitiatorConfig& config, const SpeedLimits& of_paper) {
  const SpeedLimits speeds{config.min_speed.value_or(of_paper.min), config.max_speed.value_or(of_paper.max)};
  speeds.validate();
  return speeds;
}

std::vector<std::string> common_initiator_keys() {
  std::vector<std::string> names{kVariant, kPositionSigma};
  for (const NumberKey& key : kNumberKeys) names.emplace_back(key.name);
  for (const CountKey& key : kCountKeys) names.emplace_back(key.name);
  return names;
}

void read_initiator_config(const core::YamlMap& map, std::span<const InitiatorKey> keys,
                           InitiatorConfig& config) {
  for (const InitiatorKey& key : keys) read_key(map, key, config);
  map.finish();
  if (config.max_speed && *config.max_speed <= config.min_speed.value_or(0.0))
    map.fail("max_speed", "must be > min_speed");
  if (config.range_sigma.has_value() != config.azimuth_sigma.has_value())
    map.fail(config.range_sigma ? "range_sigma" : "azimuth_sigma_deg",
             "range_sigma and azimuth_sigma_deg are given together, or neither");
}

}  // namespace lookout::tracking
