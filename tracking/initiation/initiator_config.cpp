#include "tracking/initiation/initiator_config.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"
#include "core/yaml_reader.hpp"

namespace lookout::tracking {
namespace {

void require_positive(const std::optional<double>& value, const char* field) {
  if (value) core::require_positive(field, *value);
}

std::optional<int> optional_integer(const core::YamlMap& map, const char* key, std::optional<int> before,
                                    double least) {
  if (!map.has(key)) return before;
  return map.integer(key, 0, core::Range{least, 1e6});
}

void read(const core::YamlMap& map, const char* key, const core::Range& range, std::optional<double>& value,
          double unit = 1.0) {
  if (const auto given = map.optional_number(key, range)) value = *given * unit;
}

}  // namespace

Eigen::Matrix2d polar_noise(const Eigen::Vector2d& offset, double range_sigma, double azimuth_sigma) {
  const double range = offset.norm();
  if (range == 0.0) return range_sigma * range_sigma * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d along = offset / range;
  const Eigen::Vector2d across(-along.y(), along.x());
  // The error across the line of sight is at least a thousandth of the range error, so that it is never 0 at
  // the sensor itself.
  const double across_sigma = std::max(range * azimuth_sigma, 1e-3 * range_sigma);
  return range_sigma * range_sigma * along * along.transpose() +
         across_sigma * across_sigma * across * across.transpose();
}

Eigen::Matrix2d InitiatorConfig::noise_at(const Eigen::Vector2d& position) const {
  if (range_sigma && azimuth_sigma) return polar_noise(position, *range_sigma, *azimuth_sigma);
  return position_sigma * position_sigma * Eigen::Matrix2d::Identity();
}

void InitiatorConfig::validate() const {
  require_positive(position_sigma, "position_sigma");
  require_positive(range_sigma, "range_sigma");
  require_positive(azimuth_sigma, "azimuth_sigma");
  if (range_sigma.has_value() != azimuth_sigma.has_value())
    throw std::invalid_argument("range_sigma and azimuth_sigma must be given together, or neither");
  if (min_speed) core::require(*min_speed >= 0.0, "min_speed must be >= 0", *min_speed);
  if (max_speed)
    core::require(*max_speed > min_speed.value_or(0.0), "max_speed must be > min_speed", *max_speed);
  if (acceleration_sigma)
    core::require(*acceleration_sigma >= 0.0, "acceleration_sigma must be >= 0", *acceleration_sigma);
  if (gate_margin) core::require(*gate_margin >= 0.0, "gate_margin must be >= 0", *gate_margin);
  if (max_turn)
    core::require(*max_turn > 0.0 && *max_turn <= std::numbers::pi, "max_turn must be in (0, pi]", *max_turn);
  if (window_scans) core::require(*window_scans >= 2, "window_scans must be >= 2", *window_scans);
  if (min_plots) core::require(*min_plots >= 2, "min_plots must be >= 2", *min_plots);
  require_positive(rho_step, "rho_step");
  require_positive(rho_tolerance, "rho_tolerance");
  require_positive(theta_tolerance, "theta_tolerance");
  require_positive(sensor_range, "sensor_range");
  require_positive(max_false_tracks, "max_false_tracks");
  require_positive(clutter_per_area, "clutter_per_area");
  if (theta_step)
    core::require(*theta_step > 0.0 && *theta_step <= std::numbers::pi / 4, "theta_step must be in (0, pi/4]",
                  *theta_step);
  if (peak_threshold)
    core::require(*peak_threshold > 0.0 && *peak_threshold <= 1.0, "peak_threshold must be in (0, 1]",
                  *peak_threshold);
  if (gate_probability)
    core::require(*gate_probability > 0.0 && *gate_probability < 1.0, "gate_probability must be in (0, 1)",
                  *gate_probability);
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

void read_initiator_config(const core::YamlMap& map, InitiatorConfig& config) {
  const core::Range share{0.0, 1.0, true};
  const double degree = core::radians(1.0);
  config.variant = map.text("variant", config.variant);
  config.position_sigma = map.number("position_sigma", config.position_sigma, core::kPositive);
  read(map, "range_sigma", core::kPositive, config.range_sigma);
  read(map, "azimuth_sigma_deg", core::kPositive, config.azimuth_sigma, degree);
  read(map, "min_speed", core::kNotNegative, config.min_speed);
  read(map, "max_speed", core::kPositive, config.max_speed);
  read(map, "acceleration_sigma", core::kNotNegative, config.acceleration_sigma);
  read(map, "gate_margin", core::kNotNegative, config.gate_margin);
  read(map, "max_turn_deg", core::Range{0.0, 180.0, true}, config.max_turn, degree);
  config.window_scans = optional_integer(map, "window_scans", config.window_scans, 2);
  config.min_plots = optional_integer(map, "min_plots", config.min_plots, 2);
  read(map, "rho_step", core::kPositive, config.rho_step);
  read(map, "theta_step_deg", core::Range{0.0, 45.0, true}, config.theta_step, degree);
  read(map, "rho_tolerance", core::kPositive, config.rho_tolerance);
  read(map, "theta_tolerance_deg", core::kPositive, config.theta_tolerance, degree);
  read(map, "sensor_range", core::kPositive, config.sensor_range);
  read(map, "peak_threshold", share, config.peak_threshold);
  config.max_tracks = optional_integer(map, "max_tracks", config.max_tracks, 1);
  read(map, "gate_probability", core::Range{0.0, 0.999999999, true}, config.gate_probability);
  read(map, "max_false_tracks", core::kPositive, config.max_false_tracks);
  read(map, "clutter_per_area", core::kPositive, config.clutter_per_area);
  map.finish();
  if (config.max_speed && *config.max_speed <= config.min_speed.value_or(0.0))
    map.fail("max_speed", "must be > min_speed");
  if (config.range_sigma.has_value() != config.azimuth_sigma.has_value())
    map.fail(config.range_sigma ? "range_sigma" : "azimuth_sigma_deg",
             "range_sigma and azimuth_sigma_deg are given together, or neither");
}

}  // namespace lookout::tracking
