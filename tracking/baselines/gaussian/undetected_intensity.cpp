#include "tracking/baselines/gaussian/undetected_intensity.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

void PopulationParams::validate() const {
  core::require_positive("expected_targets", expected_targets);
  core::require_positive("stay", stay);
  core::require_not_negative("settling_scans", settling_scans);
  core::require_not_negative("settling_share", settling_share);
}

UndetectedIntensity::UndetectedIntensity(const PopulationParams& params, const core::SonarParams& sonar)
    : params_(params),
      stay_s_(params.stay * sonar.max_range / sonar.max_speed),
      scan_period_(sonar.scan_period) {
  params_.validate();
}

double UndetectedIntensity::survival(double seconds) const {
  return std::exp(-seconds / stay_s_);
}

void UndetectedIntensity::predict(double seconds, double area) {
  const double full = params_.expected_targets / area;
  const double survive = survival(seconds);
  density_ = survive * density_ + (1.0 - survive) * full;
  // No time has passed before the first scan: it counts as one scan period.
  const double scans = started_ ? seconds / scan_period_ : 1.0;
  const double settling = std::min(scans, std::max(0.0, params_.settling_scans - settled_scans_));
  density_ += settling * params_.settling_share * full;
  settled_scans_ += scans;
  started_ = true;
}

}  // namespace lookout::tracking
