#include "csht/likelihood/sensor_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr double kLeastProbability = 0.005;  // A silence or a return is then worth 5.3 nats at most, ln 200.
constexpr double kLeastClutter = 0.01;       // Returns a scan.

double away_from_certainty(double probability) {
  return std::clamp(probability, kLeastProbability, 1.0 - kLeastProbability);
}

}  // namespace

SensorFigures figures_of(const core::SonarParams& params) {
  SensorFigures figures;
  figures.miss_probability = away_from_certainty(params.miss_probability.value_or(figures.miss_probability));
  figures.false_alarm_probability =
      away_from_certainty(params.false_alarm_probability.value_or(figures.false_alarm_probability));
  figures.clutter_per_scan =
      std::max(kLeastClutter, params.clutter_per_scan.value_or(figures.clutter_per_scan));
  figures.resolution = params.resolution;
  figures.heading_sigma = params.heading_sigma;
  figures.position_sigma = params.position_sigma;
  figures.range_sigma = std::hypot(params.range_sigma, params.position_sigma);
  figures.bearing_sigma = std::hypot(params.bearing_sigma_or_default(), params.heading_sigma);
  return figures;
}

ClutterModel clutter_model_of(const core::SonarParams& params) {
  return params.point_sensor() ? ClutterModel::point : ClutterModel::exclusive_beam;
}

void validate(const SensorFigures& figures) {
  core::require_inner_share("miss_probability", figures.miss_probability);
  core::require_inner_share("false_alarm_probability", figures.false_alarm_probability);
  core::require_share_below_one("range_loss", figures.range_loss);
  core::require_share_below_one("tail_share", figures.tail_share);
  core::require(figures.clutter_per_scan > 0.0, "clutter_per_scan must be > 0", figures.clutter_per_scan);
  core::require(figures.range_sigma > 0.0, "range_sigma must be > 0", figures.range_sigma);
  core::require(figures.bearing_sigma > 0.0, "bearing_sigma must be > 0", figures.bearing_sigma);
  core::require_not_negative("resolution", figures.resolution);
  core::require_not_negative("heading_sigma", figures.heading_sigma);
  core::require_not_negative("position_sigma", figures.position_sigma);
}

void validate(const SensorModelParams& params) {
  core::require(params.log_floor >= -50.0 && params.log_floor < 0.0, "log_floor must be in [-50, 0)",
                params.log_floor);
}

}  // namespace lookout::csht
